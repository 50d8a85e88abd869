// "lights": [{"name": "key", "intensity": 20}, ...]: changes to the lights of a scene, by their names.
// SPDX-License-Identifier: MIT
#pragma once
#include <vector>

#include "techniques/foundation/scene/json/json_object.h"
#include "techniques/foundation/scene/model/light.h"

namespace shadowlab::film {

/// Applies what `key` has under "lights"; nothing when it has none. Every light may be named once. Throws Error (badInput)
/// with FILE:LINE:COLUMN for lights that are not there, and for what a scene file may not say of them either.
void readLightChanges(const scene::JsonObject& key, std::vector<scene::Light>& lights);

} // namespace shadowlab::film
