// The map projected onto what the eye sees (shaders/shadow_map/project.frag).
// SPDX-License-Identifier: MIT
#pragma once
#include <vector>

#include "techniques/shadow_map/map_tools.h"

namespace shadowlab::shadow_map {

/// What is drawn for each visible point; the numbers are those of the shader.
enum class Projected {
    mapDepth = 0,      ///< metres from the light that the map holds
    pointDistance = 1, ///< metres from the light to the point itself
    comparison = 2,    ///< colours: which of the two is less
    position = 3,      ///< the point relative to the light
    plane = 4,         ///< depth that the point is compared with, and how it varies with u and v on the point's plane
};

void drawProjected(MapTools& tools, const Frame& frame, int light, const LightShadowMap& map, Projected what);

/// The same as numbers, rows from the top; alpha is 0 where nothing is visible.
std::vector<vec4> projectedTexels(MapTools& tools, const Frame& frame, int light, const LightShadowMap& map,
                                  Projected what);

} // namespace shadowlab::shadow_map
