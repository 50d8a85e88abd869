// The icons of the buttons, drawn as lines and areas: sharp in every size, and without a font of their own.
// SPDX-License-Identifier: MIT
#pragma once
#include <imgui.h>

namespace shadowlab::window {

enum class Icon { single, side, split, grid, difference, play, pause, undo, redo, save, present, help, panel, stages, lens };

/// Into the square of that side with its upper left corner there, in pixels.
void drawIcon(ImDrawList& list, Icon icon, ImVec2 corner, float side, ImU32 color);

/// A square button with an icon, as high as other widgets; highlighted while it is on. True when it was pressed.
bool iconButton(const char* id, Icon icon, bool on, const char* help);

} // namespace shadowlab::window
