// A scene's triangles for a shader that walks from one to the next (shaders/shadow_map/walk.glsl).
// SPDX-License-Identifier: MIT
#pragma once
#include "techniques/foundation/gl/texture.h"
#include "techniques/shadow_map/fit/light_maps.h"
#include "techniques/shadow_map/topologies.h"

namespace shadowlab::shadow_map {

/// A triangle beyond an edge that is not there, or that more than one shares.
constexpr std::uint32_t kNoNeighbour = ~std::uint32_t{0};

/// Two texels for each triangle of all objects, counted through: the numbers of its corners and 1 if it may have a hole, and
/// the numbers of the triangles beyond the edges that follow the corners.
gl::TableTexture walkTriangles(const scene::Scene& scene, Topologies& topologies);

/// Where the corners of all objects are, relative to a light, in the same order.
gl::TableTexture walkPositions(const scene::Scene& scene, const LightMaps& maps);

} // namespace shadowlab::shadow_map
