// `[SLOT:]ID.PARAM=VALUE`: setting the parameters of slots from text.
// SPDX-License-Identifier: MIT
#pragma once
#include <string>
#include <vector>

#include "app/picture/session.h"

namespace shadowlab::lab {

struct Setting {
    int slot = 0; ///< counted from 1; 0: every slot of the technique
    std::string id, param, value;
};

/// Throws Error (usage) for what is no setting.
Setting parseSetting(const std::string& text);

/// Applies the settings in order. A setting without a slot number goes to every slot of that technique.
/// Throws Error (usage) for anything unknown, out of range, or meant for a technique that no slot shows.
void applySettings(std::vector<picture::Slot>& slots, const std::vector<std::string>& settings);

/// A sentence for each parameter that was set and has no effect with the others as they are: for example an aperture with one ray
/// for each pixel.
std::vector<std::string> settingsWithoutEffect(const std::vector<picture::Slot>& slots);

} // namespace shadowlab::lab
