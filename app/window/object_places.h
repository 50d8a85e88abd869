// What of a pane's picture is about something: objects, and from outside the signs and labels of what stands in the scene.
// SPDX-License-Identifier: MIT
#pragma once
#include "app/window/free_places.h"

namespace shadowlab::window {

/// Takes the objects that the pane shows, but for those that fill it, floors and rooms; and the labels of a picture from outside.
FreePlaces placesBesideThings(WindowState& ui, const ShownPane& pane, const Theme& theme);

} // namespace shadowlab::window
