// Handles of lights and objects in the picture: to be seen, taken hold of, and dragged.
// SPDX-License-Identifier: MIT
#pragma once
#include "app/window/free_places.h"
#include "app/window/pictures.h"

namespace shadowlab::window {

/// How long the handle of a light flashes that stages and errors are about from now on.
constexpr double kFlashSeconds = 1.75; // long enough to look for it

/// Lets the mouse drag lights and objects in every pane that shows the scene through the eye's camera (lab/dragging.h): by their
/// discs, by any place of an object, and by the mark at the picture's edge of what lies outside it. With Shift up and
/// down; by an arrow along its axis. The split line lies over objects, and its knob over all. True while one is held.
bool handleGizmos(WindowState& ui, const std::vector<ShownPane>& panes, const Area& pictures, const Theme& theme);

/// Draws the handles of one pane: of lights, with their names, and of the objects that are selected or under the mouse.
/// What they cover is taken from the pane's free places. Returns where the names stand.
std::vector<PlaceBox> drawGizmos(ImDrawList& list, WindowState& ui, const ShownPane& pane, FreePlaces& places, const Theme& theme);

/// Where the handles of lights and objects lie in a pane, or their marks at its edge, by name, in pixels of the window.
std::vector<std::pair<std::string, dvec2>> handlePlaces(WindowState& ui, const ShownPane& pane, const Theme& theme);

} // namespace shadowlab::window
