// What is on the screen, as a line of JSON: how tests, and whoever drives the window from outside, know that what they
// asked for is there, without waiting by the clock.
// SPDX-License-Identifier: MIT
#pragma once
#include <string>

#include "app/window/screen.h"

namespace shadowlab::window {

/// {"ran": [...], "settled": ..., "scene": ..., "layout": ..., "active": ..., "panes": [...], "camera": {...}, ...}
std::string stateReport(Desk& desk, const Screen& screen);

} // namespace shadowlab::window
