// Where, in the light's picture of a scene, one surface may end, begin or change places with another.
//
// Within a piece of that picture which no such edge touches, the surfaces lie over each other like sheets of paper: each
// covers the whole piece, and their order is the same everywhere in it. So what one light ray through the piece finds is
// true of all others. (Hertel, Hormann and Westermann, "A Hybrid GPU Rendering Pipeline for Alias-Free Hard Shadows",
// Eurographics 2009, who call texels uncertain where a triangle covers a part of them; here edges inside a surface do not
// count.)
// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <functional>
#include <span>

#include "techniques/foundation/scene/query/topology/mesh_topology.h"

namespace shadowlab::shadow_map {

/// Calls found(a, b) with the welded vertices of each edge at which the surface does not simply go on as the light sees
/// it: not two triangles, one to either side of the edge. `facing` is one sign per triangle (scene/query/facing.h).
void forEachLooseEdge(const scene::MeshTopology& topology, std::span<const std::int8_t> facing,
                      const std::function<void(std::uint32_t a, std::uint32_t b)>& found);

} // namespace shadowlab::shadow_map
