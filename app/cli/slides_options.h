// What `slides` is asked for: its options, described and checked.
// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "app/context/context.h"
#include "app/course/slides/slide_painter.h"

namespace CLI {
class App;
}

namespace shadowlab::cli {

struct SlidesOptions {
    std::vector<std::string> decks; ///< names or files; empty: all that are built in
    std::vector<std::string> only;  ///< names of slides; empty: all
    std::filesystem::path output;   ///< a folder
    course::SlideLook look;
    context::Backend backend = context::Backend::automatic;
    std::vector<std::filesystem::path> allowed;
};

void describeSlides(CLI::App& command);

/// Throws Error (usage, overLimit) for what is wrong in itself; what depends on the decks is seen later.
SlidesOptions slidesOptions(const CLI::App& command);

} // namespace shadowlab::cli
