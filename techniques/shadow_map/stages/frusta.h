// The shadow map's cameras as they lie in the scene: what of the world each of a light's maps can hold.
// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <vector>

#include "techniques/shadow_map/fit/light_maps.h"
#include "techniques/technique.h"

namespace shadowlab::shadow_map {

/// Corners, in world space, of what one layer holds: four of the near plane, around the picture, then the four of the far
/// plane in the same order. (What is nearer than the near plane is kept too, by the depth clamp.)
std::array<dvec3, 8> frustumCornersWorld(const LightMaps& maps, int layer);

/// The edges of all frusta, from the light itself to the far plane, and their near planes filled.
std::vector<SceneShape> frustumShapes(const LightMaps& maps, bool cascadesInOneColor = false);

} // namespace shadowlab::shadow_map
