// The pictures of the panes, with what is drawn over them and the legends below, and the split line.
// SPDX-License-Identifier: MIT
#pragma once
#include "app/lab/errors/live_errors.h"
#include "app/window/pane_frames.h"

namespace shadowlab::window {

/// Draws them behind all widgets.
void drawPictures(WindowState& ui, const lab::LiveErrors& errors, const std::vector<ShownPane>& panes, const PaneFrames& frames,
                  const Theme& theme);

/// What is to be said of the pane while its picture is not finished: in full, and shorter. One empty text when there is nothing.
std::vector<std::string> progressOf(const WindowState& ui, const lab::LiveErrors& errors, int pane);

} // namespace shadowlab::window
