// What went wrong in one case, to be seen: the student's picture, the truth or the right picture, and the difference, side by side.
// SPDX-License-Identifier: MIT
#pragma once
#include <optional>
#include <string>

#include "app/judge/verdict.h"
#include "techniques/foundation/image/image.h"

namespace shadowlab::student {

/// `student` is as large as the truth; without one its place says why (`failure`). Twice as large as drawn, so that pixels can be
/// told apart.
image::Image scorePicture(std::optional<image::Image> student, const std::string& failure, const judge::Truth& truth,
                          const judge::Judgement& judgement);

/// The same of a case that has a right picture. `levels`: what counts as a difference.
image::Image scorePicture(std::optional<image::Image> student, const std::string& failure, const image::Image& right,
                          int levels);

} // namespace shadowlab::student
