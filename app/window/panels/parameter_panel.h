// The settings of the active pane's technique, made from its parameter list: a checkbox, slider or choice for each, with
// its help, its range and a way back to its default.
// SPDX-License-Identifier: MIT
#pragma once
#include "app/window/desk.h"
#include "app/window/theme.h"

namespace shadowlab::window {

void parameterPanel(Desk& desk, const Theme& theme);

} // namespace shadowlab::window
