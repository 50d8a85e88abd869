// What the colours of a stage mean: a bar with numbers, or a key, on a plate in the lower left corner of its pane.
// SPDX-License-Identifier: MIT
#pragma once
#include "app/lab/pane.h"
#include "app/window/theme.h"

namespace shadowlab::window {

/// Nothing for pictures that need no legend, or (but for `always`) have no texture, and where it would cover more than half of the area.
/// Returns the size of the plate, in pixels.
ImVec2 drawLegend(ImDrawList& list, const lab::PanePicture& picture, bool always, ivec2 corner, ivec2 size,
                  const Theme& theme);

} // namespace shadowlab::window
