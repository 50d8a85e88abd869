// The frames around what there is to see in a lesson's picture.
// SPDX-License-Identifier: MIT
#pragma once
#include <vector>

#include "app/course/lessons/lesson.h"
#include "techniques/foundation/image/text.h"

namespace shadowlab::course {

/// Frames what to look at. Where the artefact is, it is named: above the box, else below it, else in it, as there is room. `em`
/// is the type size in pixels.
void drawLook(image::Image& picture, const std::vector<LookBox>& look, bool named, const image::Font& font, double em);

} // namespace shadowlab::course
