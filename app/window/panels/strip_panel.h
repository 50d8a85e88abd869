// The strip of stages below the pictures; a click fills the active pane.
// SPDX-License-Identifier: MIT
#pragma once
#include "app/lab/stage_strip.h"
#include "app/window/pictures.h"

namespace shadowlab::window {

/// The size of one small picture.
ivec2 thumbnailSize(const Theme& theme);
float stripHeight(const Theme& theme);
void stripPanel(Desk& desk, const lab::StageStrip& strip, const Area& area, const Theme& theme);

} // namespace shadowlab::window
