// The card beside the picked pixel: lit or in shadow, and the sums that lead there.
// SPDX-License-Identifier: MIT
#pragma once
#include "app/window/pane_frames.h"

namespace shadowlab::window {

/// In the active pane, on the side of the pixel where there is room. Nothing while no pixel is picked, or its probe is not known.
void drawProbeCard(ImDrawList& list, const WindowState& ui, const ShownPane& shown, const Theme& theme);

} // namespace shadowlab::window
