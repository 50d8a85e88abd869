// Pieces that several panels are made of: a window that fills its area, buttons with help.
// SPDX-License-Identifier: MIT
#pragma once
#include <string>

#include "app/window/pictures.h"
#include "app/window/theme.h"

namespace shadowlab::window {

/// Begins an ImGui window that fills the area and stays there; ImGui::End() ends it. True while any of it is visible.
bool beginIn(const char* name, const Area& area, ImGuiWindowFlags flags = 0);

/// How high a text of that size is when it is wrapped at that width, all in pixels.
float wrappedHeight(ImFont* font, float size, const std::string& text, float width);

/// What of the text fits into the width in pixels, with an ellipsis in place of the rest; in type of that size, or of the present one.
std::string cutTo(const std::string& text, float width, float size);
std::string cutTo(const std::string& text, float width);

/// A sentence in lines that do not break its numbers (line_breaks.h), as wide as there is room.
void wholeNumbersText(const std::string& text);

/// A tooltip for the last item.
void hint(const char* text);

/// A button that is highlighted while it is on. True when it was pressed.
bool toggleButton(const char* label, bool on, const char* help);

} // namespace shadowlab::window
