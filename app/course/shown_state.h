// All that one picture shows: a scene from a camera, by techniques with their parameters. Lessons and slides are made of these.
// SPDX-License-Identifier: MIT
#pragma once
#include <string>
#include <vector>

#include "app/lab/document.h"

namespace shadowlab::course {

struct ShownState {
    scene::Snapshot scene; ///< with the lights as the file has them
    std::string sceneName; ///< as the command line takes it
    scene::Camera camera;
    picture::Layout layout = picture::Layout::single;
    double split = 0.5; ///< share of the width that the left one has, where the layout is `split`
    int light = 0;
    std::vector<lab::PaneState> slots;      ///< one for each technique on show
    std::vector<std::string> settings; ///< as the file has them, for people to read
};

/// The state as the window shows it.
lab::Document documentOf(const ShownState& state);

/// Slots with the settings of the state. Throws Error (usage) for values out of range.
std::vector<picture::Slot> slotsOf(const std::vector<lab::PaneState>& states);

} // namespace shadowlab::course
