// `shadowlab lesson`; also called by `demo` where there is no display.
// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/context/context.h"
#include "techniques/foundation/math/types.h"

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

/// Draws a lesson, measures it, or both. Throws Error (badInput) when what was measured is not as the lesson says.
int lesson(const LessonOptions& options);

} // namespace shadowlab::cli
