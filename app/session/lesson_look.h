// The picture of one state of a lesson, and the frames around what there is to see in it.
// SPDX-License-Identifier: MIT
#pragma once
#include <vector>

#include "app/session/lesson.h"
#include "techniques/foundation/image/text.h"

namespace shadowlab::session {

/// Draws the state's slots, with titles and legends like those of any capture. Needs a current GL context.
image::Image drawState(const LessonState& state, ivec2 size, const image::Font& font);

/// Frames what to look at. Where the artefact is, it is named: above the box, else below it, else in it, as there is room. `em`
/// is the type size in pixels.
void drawLook(image::Image& picture, const std::vector<LookBox>& look, bool named, const image::Font& font, double em);

} // namespace shadowlab::session
