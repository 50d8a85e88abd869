// Handles of lights and objects in the picture: to be seen, taken hold of, and dragged.
// SPDX-License-Identifier: MIT
#pragma once
#include "app/ui/pictures.h"

namespace shadowlab::ui {

/// Draws the handles in every pane that shows the scene through the eye's camera, and lets the mouse drag them: the disc
/// level with the ground (with Shift up and down), an arrow along its axis. True while one is held.
bool handleGizmos(Desk& desk, const std::vector<ShownPane>& panes, const Theme& theme);

} // namespace shadowlab::ui
