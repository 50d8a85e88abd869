// The list of all keys, over everything: what is on it comes from the actions themselves.
// SPDX-License-Identifier: MIT
#pragma once
#include "app/ui/theme.h"

namespace shadowlab::ui {

void keyOverlay(ivec2 windowSize, const Theme& theme);

} // namespace shadowlab::ui
