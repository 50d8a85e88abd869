// What the colours of a stage mean: a bar with numbers, or a key, in the band below its picture.
// SPDX-License-Identifier: MIT
#pragma once
#include "app/lab/pane.h"
#include "app/window/pane_frames.h"

namespace shadowlab::window {

/// Into the band, in the type of the headers. Smaller type where the band has too few lines for it. Nothing for pictures that need
/// no legend.
void drawLegend(ImDrawList& list, const lab::PanePicture& picture, const Area& band, const Theme& theme);

/// The lines that it needs at a width in pixels, of `most`; 0 where there is none.
int legendLines(const lab::PanePicture& picture, int width, int most, const Theme& theme);

} // namespace shadowlab::window
