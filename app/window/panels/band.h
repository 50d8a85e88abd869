// A band below the pictures, through which one goes back and on: lessons and slides.
// SPDX-License-Identifier: MIT
#pragma once
#include <string>

#include "app/window/pictures.h"
#include "app/window/theme.h"

namespace shadowlab::window {

struct BandHeading {
    const char* name; ///< of the ImGui window
    std::string title;
    std::string place; ///< where one is, in the accent's colour
    const char* hint;  ///< the keys, at the right end where there is room
};

/// Begins the band: arrows, heading, hint. The caller writes the rest and calls ImGui::End(). Returns which arrow was clicked: -1
/// back, 1 on, 0 none.
int beginBand(const BandHeading& heading, const Area& area, const Theme& theme);

/// How high a text of that size is that is wrapped at that width, all in pixels.
float wrappedHeight(ImFont* font, float size, const std::string& text, float width);

} // namespace shadowlab::window
