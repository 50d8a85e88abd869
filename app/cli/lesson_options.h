// What `lesson` is asked to do: its options, described and checked.
// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/context/context.h"
#include "techniques/foundation/math/types.h"

namespace CLI {
class App;
}

namespace shadowlab::cli {

struct LessonOptions {
    std::string lesson;
    std::filesystem::path output;          ///< empty: no picture
    std::vector<std::size_t> states{0, 1}; ///< which to draw: before, after
    ivec2 size{1600, 900};
    bool animate = false;              ///< all that the lesson shows, one after the other, in one file
    std::optional<double> holdSeconds; ///< of each picture of an animation; without it as long as it takes to read
    bool measure = false, json = false;
    context::Backend backend = context::Backend::automatic;
    std::vector<std::filesystem::path> allowed;
};

void describeLesson(CLI::App& command);

/// From what was written to what is meant. Throws Error (usage, overLimit).
LessonOptions lessonOptions(const CLI::App& command);

} // namespace shadowlab::cli
