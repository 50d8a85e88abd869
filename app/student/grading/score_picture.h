// What went wrong in one case, to be seen: the student's picture, the truth, and the difference, side by side.
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

} // namespace shadowlab::student
