// What the colours of a stage mean: a bar with numbers, or a key, in the band below its picture.
// SPDX-License-Identifier: MIT
#pragma once
#include "app/lab/pane.h"
#include "app/window/pane_frames.h"

namespace shadowlab::window {

/// In one line, in smaller type where it is long; what does not fit even so stands in further lines that reach up over the
/// picture's edge. Nothing for pictures that need no legend.
void drawLegend(ImDrawList& list, const lab::PanePicture& picture, const Area& band, const Theme& theme);

} // namespace shadowlab::window
