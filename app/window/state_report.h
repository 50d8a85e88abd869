// What is on the screen, as JSON: tests, and other programs that drive the window, read from it that what they asked for is
// there, without waiting for a fixed time.
// SPDX-License-Identifier: MIT
#pragma once
#include <string>

#include <nlohmann/json_fwd.hpp>

#include "app/window/screen.h"

namespace shadowlab::window {

/// {"ran": [...], "settled": ..., "scene": ..., "layout": ..., "active": ..., "panes": [...], "camera": {...}, ...}
nlohmann::ordered_json stateReport(WindowState& ui, const Screen& screen);

/// The report as one line of text. Bytes that are no UTF-8, as a file's name may hold, are replaced.
std::string stateLine(const nlohmann::ordered_json& report);

} // namespace shadowlab::window
