// What `new-technique` is asked for.
// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <string>

namespace CLI {
class App;
}

namespace shadowlab::cli {

struct NewTechniqueOptions {
    std::string name;             ///< the technique's id: "my-shadows"
    std::string from = "empty";   ///< a skeleton
    std::filesystem::path output; ///< the folder to be made; empty: NAME in the current one
};

void describeNewTechnique(CLI::App& command);

/// From what was written to what is meant. Throws Error (usage).
NewTechniqueOptions newTechniqueOptions(const CLI::App& command);

} // namespace shadowlab::cli
