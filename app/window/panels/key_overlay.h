// The list of all keys, over everything: what is on it comes from the actions themselves.
// SPDX-License-Identifier: MIT
#pragma once
#include "app/window/theme.h"

namespace shadowlab::window {

void keyOverlay(ivec2 windowSize, const Theme& theme);

} // namespace shadowlab::window
