// The program's window: feeds keys, mouse and dropped files to the screen, and shows what it has drawn.
// SPDX-License-Identifier: MIT
#pragma once
#include <string>

#include "techniques/foundation/math/types.h"
#include "techniques/foundation/scene/load/load.h"

namespace shadowlab::window {

struct WindowSettings {
    std::string scene = "still-life"; ///< a built-in name, a .json, or a mesh
    std::string lesson;               ///< to begin with, a built-in name or a .json; empty: none
    std::string deck;                 ///< the same of slides
    std::string slide;                ///< the name of one of the deck's; empty: the first
    ivec2 size{1280, 720};            ///< screen coordinates
    bool presenter = false;
    bool keepSettings = true; ///< reads what the last run stored, and stores it for the next
    bool report = false;      ///< writes a line of JSON to standard output for every change that is on the screen
};

/// Runs until the window is closed. Throws Error (noContext) without a display, Error (badInput) when the first scene
/// cannot be loaded.
int runWindow(const WindowSettings& settings, const scene::LoadOptions& loading);

} // namespace shadowlab::window
