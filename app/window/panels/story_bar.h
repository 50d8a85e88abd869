// The band below the pictures: one of Explore, Steps, Lessons and Slides, laid out alike. A drawing of a slide stands at the right,
// as high as there is room.
// SPDX-License-Identifier: MIT
#pragma once
#include "app/window/pictures.h"
#include "app/window/slide_figure.h"
#include "app/window/theme.h"
#include "app/window/window_state.h"

namespace shadowlab::window {

/// Where pictures, band and drawing are. An empty size: it is not there.
struct StoryLayout {
    Area room; ///< all of it
    Area pictures, band, figure;
};

/// Divides the room between the top bar and the strip.
StoryLayout layStory(const WindowState& ui, const Area& room, const Theme& theme);

/// Draws the band and the drawing.
void storyBar(WindowState& ui, const SlideFigure& figure, const StoryLayout& layout, const Theme& theme);

} // namespace shadowlab::window
