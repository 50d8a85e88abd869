// The magnifier: the same place of every pane's picture, enlarged until single pixels are seen.
// SPDX-License-Identifier: MIT
#pragma once
#include "app/window/pictures.h"

namespace shadowlab::window {

/// In the lower right corner of each pane. The place is where the mouse was last over a picture.
void drawMagnifiers(Desk& desk, const std::vector<ShownPane>& panes, const Theme& theme);

} // namespace shadowlab::window
