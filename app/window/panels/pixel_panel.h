// What the active pane's technique knows about the picked pixel: facts, and the tree of its rays.
// SPDX-License-Identifier: MIT
#pragma once
#include "app/window/desk.h"

namespace shadowlab::window {

/// Nothing while no pixel is picked.
void pixelPanel(Desk& desk);

} // namespace shadowlab::window
