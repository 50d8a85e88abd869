// The card about the picked pixel: lit or in shadow, and the sums that lead there.
// SPDX-License-Identifier: MIT
#pragma once
#include "app/window/free_places.h"

namespace shadowlab::window {

/// In the active pane, in a corner away from the pixel, from lamps and from objects, with a line to the pixel's ring. Nothing while
/// no pixel is picked, or its probe is not known.
void drawProbeCard(ImDrawList& list, const WindowState& ui, const ShownPane& shown, const FreePlaces& places, const Theme& theme);

} // namespace shadowlab::window
