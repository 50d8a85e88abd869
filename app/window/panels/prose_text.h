// Words with formulas among them in the window: set as on slides (drawing/prose.h), in the window's type.
// SPDX-License-Identifier: MIT
#pragma once
#include <string>

#include "app/window/theme.h"

namespace shadowlab::window {

/// Pixels from the first line's top to the last one's bottom. `text` has formulas between $.
float proseHeight(const std::string& text, float width, const Theme& theme);

/// At the cursor, in lines of that width, which the cursor then stands below.
void proseText(const std::string& text, float width, ImU32 color, const Theme& theme);

/// Pixels of it in one line.
float proseWidth(const std::string& text, const Theme& theme);
/// The theme for prose as large as headings are.
Theme forHeading(Theme theme);

} // namespace shadowlab::window
