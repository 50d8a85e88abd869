// The pictures of a lesson for the page of lessons.
// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <cstdint>
#include <functional>
#include <vector>

#include "app/course/lessons/lesson.h"
#include "techniques/foundation/image/text.h"

namespace shadowlab::course {

/// Pixels: as large as a laptop shows them beside the words, in the shape that lessons are made for.
constexpr ivec2 kPagePictureSize{768, 432};

/// The frames of both states as WebP; one of each, where nothing moves. They are what `lesson` draws, without its words and frames, and
/// several techniques stand side by side with their names. `onPicture` is called after each, and may throw. Needs a current GL context.
using LessonFrames = std::vector<std::vector<std::uint8_t>>;
std::array<LessonFrames, 2> lessonPictures(const Lesson& lesson, const image::Font& font, const std::function<void()>& onPicture);

} // namespace shadowlab::course
