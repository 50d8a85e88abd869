// Lights that stand inside of a caster: a bulb in its globe, whose light never comes out.
// SPDX-License-Identifier: MIT
#pragma once
#include <string>
#include <vector>

#include "techniques/foundation/scene/model/scene.h"

namespace shadowlab::scene {

/// A note for every light that one caster encloses, seen from an eye that it does not enclose. A room around the light and the
/// eye is no such caster.
std::vector<std::string> notesOnHiddenLights(const Scene& scene);

} // namespace shadowlab::scene
