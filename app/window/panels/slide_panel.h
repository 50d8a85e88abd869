// Below the pictures, while a deck is on: the slide's title, which of its pictures is on show, and what it says.
// SPDX-License-Identifier: MIT
#pragma once
#include "app/window/panels/panels.h"
#include "app/window/theme.h"

namespace shadowlab::window {

/// Pixels; 0 while no deck is on.
float slidePanelHeight(const Desk& desk, const Theme& theme, float width);
void slidePanel(Desk& desk, const Area& area, const Theme& theme);
/// All built-in decks, to be opened; of the one that is on, its slides.
void deckList(Desk& desk);

} // namespace shadowlab::window
