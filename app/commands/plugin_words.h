// `--plugin FILE`, wherever it stands on the command line: taken out before the words are read, because what else they may say
// depends on it.
// SPDX-License-Identifier: MIT
#pragma once
#include <string>
#include <vector>

namespace shadowlab::commands {

struct PluginWords {
    std::vector<std::string> files; ///< of --plugin FILE and --plugin=FILE, in order
    std::vector<std::string> words; ///< all others; the program's own name first
};

/// Words after `--` are left as they are. Throws Error (usage) for --plugin without a file, and for one that is given twice.
PluginWords takePluginWords(const std::vector<std::string>& argv);

} // namespace shadowlab::commands
