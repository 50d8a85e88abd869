// What the mouse does over the pictures.
// SPDX-License-Identifier: MIT
#pragma once
#include "app/window/pictures.h"

namespace shadowlab::window {

/// Where the mouse was pressed since the last frame, if it was; else where it is now.
ImVec2 pressPlace(const WindowState& ui);

/// Does the mouse, pressed there, take hold of the split line; of the knob in its middle?
bool isOnSplitLine(const WindowState& ui, const Area& pictures, ImVec2 place, const Theme& theme);
bool isOnSplitKnob(const WindowState& ui, const Area& pictures, ImVec2 place, const Theme& theme);

/// Orbits, pans, zooms and flies the camera, drags the split line, picks pixels, chooses the active pane. True while it moves
/// something.
bool handleMouse(WindowState& ui, const std::vector<ShownPane>& panes, const Area& area, const Theme& theme);

} // namespace shadowlab::window
