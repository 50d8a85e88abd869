// How many pixels of a pane's picture are wrong, and what is not finished yet: a line of its header.
// SPDX-License-Identifier: MIT
#pragma once
#include "app/lab/errors/live_errors.h"
#include "app/window/pane_frames.h"

namespace shadowlab::window {

/// The verdict, and what is not finished yet at its right; in its place, where there is no room for both.
void drawVerdict(const WindowState& ui, const lab::LiveErrors& errors, const PaneHeader& header, bool isBesideMenus);

/// Pixels of a verdict beside the menus: as wide as it can get, so that they do not move with its numbers. A compact header has no such
/// room: there it is its shortest form.
float verdictRoom(const WindowState& ui, const lab::LiveErrors& errors, int pane, bool isCompact);

} // namespace shadowlab::window
