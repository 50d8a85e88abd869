// What the window stores from one run to the next: its size, and which of its panels are on show. Never what the pictures show:
// every run begins with the same ones.
// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>

#include "techniques/foundation/math/types.h"

namespace shadowlab::window {

struct WindowMemory {
    ivec2 size{1280, 720};
    bool panel = true, strip = false, presenter = false, handles = true, coarse = true;
    friend bool operator==(const WindowMemory&, const WindowMemory&) = default;
};

struct WindowState;
/// What is on show is made as it was then.
void applyMemory(WindowState& ui, const WindowMemory& memory);
/// What is to be stored. The panel counts as shown where only the source or presenter mode has taken its place.
WindowMemory memoryOf(const WindowState& ui, ivec2 windowSize);

/// $XDG_CONFIG_HOME/shadowlab/window.json, or below ~/.config; empty where neither is set.
std::filesystem::path windowMemoryFile();

/// What is written there; a file that is missing or broken counts as none.
WindowMemory readWindowMemory(const std::filesystem::path& file);
/// Throws Error (cannotWrite).
void writeWindowMemory(const std::filesystem::path& file, const WindowMemory& memory);

} // namespace shadowlab::window
