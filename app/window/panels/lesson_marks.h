// A lesson's marks on the pictures: frames around what to look at, what the class paints, and how right that was.
// SPDX-License-Identifier: MIT
#pragma once
#include <imgui.h>

#include "app/window/free_places.h"
#include "app/window/pictures.h"
#include "app/window/theme.h"
#include "app/window/window_state.h"

namespace shadowlab::window {

/// Where its frames are in a pane, in pixels of the window.
std::vector<PlaceBox> lessonFrames(const WindowState& ui, const ShownPane& shown);

/// Nothing without a lesson, and nothing after the camera has left the place that the frames are for.
void drawLessonMarks(ImDrawList& list, const WindowState& ui, const ShownPane& shown, const Theme& theme);

/// While the shadow is to be painted, the mouse over the pictures paints, and does nothing else. True while it does.
bool handlePainting(WindowState& ui, const std::vector<ShownPane>& panes);

} // namespace shadowlab::window
