// The band below the pictures: one of Explore, Steps, Lessons and Slides, laid out alike. A drawing of a slide stands at the right,
// as high as there is room.
// SPDX-License-Identifier: MIT
#pragma once
#include "app/window/panels/story_layout.h"
#include "app/window/slide_figure.h"
#include "app/window/theme.h"
#include "app/window/window_state.h"

namespace shadowlab::window {

/// Draws the band and the drawing.
void storyBar(WindowState& ui, const SlideFigure& figure, const StoryLayout& layout, const Theme& theme);

} // namespace shadowlab::window
