// Every key of the window, once: the list behind the `h` overlay, the documentation and the tests.
// SPDX-License-Identifier: MIT
#pragma once
#include <span>
#include <string>

#include "app/window/window_state.h"

namespace shadowlab::window {

struct Action {
    const char* id;    ///< kebab-case, stable
    const char* group; ///< heading in the list of keys
    const char* keys;  ///< as it is written on the list: "Ctrl+S", "Right"
    const char* help;
    int key; ///< GLFW's number
    bool ctrl = false, shift = false;
    bool repeats = false; ///< goes on while the key is held
    void (*run)(WindowState& ui);
};

std::span<const Action> actions();

/// Runs what the keys of this frame ask for. Call inside an ImGui frame. Returns the ids of what ran.
std::vector<std::string> runKeys(WindowState& ui);

} // namespace shadowlab::window
