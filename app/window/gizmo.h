// Handles of lights and objects in the picture: to be seen, taken hold of, and dragged.
// SPDX-License-Identifier: MIT
#pragma once
#include "app/window/pictures.h"

namespace shadowlab::window {

/// Lets the mouse drag the handles in every pane that shows the scene through the eye's camera: the disc level with the
/// ground (with Shift up and down), an arrow along its axis. True while one is held.
bool handleGizmos(WindowState& ui, const std::vector<ShownPane>& panes, const Theme& theme);

/// Draws those of one pane: of lights, and of the objects that are selected or under the mouse.
void drawGizmos(ImDrawList& list, WindowState& ui, const ShownPane& pane, const Theme& theme);

/// Where the handles of lights and objects lie in a pane, by name, in pixels of the window; those that are seen.
std::vector<std::pair<std::string, dvec2>> handlePlaces(WindowState& ui, const ShownPane& pane);

} // namespace shadowlab::window
