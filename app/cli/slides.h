// `shadowlab slides`; also called by `demo` where there is no display.
// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "app/context/context.h"
#include "app/course/slides/slide_painter.h"

namespace shadowlab::cli {

struct SlidesOptions {
    std::vector<std::string> decks; ///< names or files
    bool allDecks = false;          ///< that are built in, in place of `decks`
    bool lessons = false;           ///< the page of lessons
    std::vector<std::string> only;  ///< names of slides and lessons; empty: all
    std::filesystem::path output;   ///< a folder
    course::SlideLook look;
    bool explores = false;               ///< slides with "explore" become labs in the page
    std::size_t exploreBytes = 14000000; ///< that those of a deck take at most
    context::Backend backend = context::Backend::automatic;
    std::vector<std::filesystem::path> allowed;
};

/// Draws decks. After a slide that fails the others are drawn all the same; the exit status is that of the first failure.
int slides(const SlidesOptions& options);

} // namespace shadowlab::cli
