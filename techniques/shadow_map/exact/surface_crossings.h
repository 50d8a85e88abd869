// Where surfaces pass through each other: the segments in which pairs of triangles cross.
// SPDX-License-Identifier: MIT
#pragma once
#include <span>
#include <vector>

#include "techniques/foundation/trace/bvh/bvh.h"
#include "techniques/foundation/trace/world_triangles.h"

namespace shadowlab::shadow_map {

struct Crossing {
    dvec3 aCentred, bCentred; ///< in the space of trace::WorldTriangles
};

/// The segment in which two triangles cross; touching counts. None where they lie in one plane.
/// Moller, "A Fast Triangle-Triangle Intersection Test", Journal of Graphics Tools 2(2), 1997.
std::optional<Crossing> crossingOf(const trace::Triangle& first, const trace::Triangle& second);

/// All crossings of triangles of the objects that have a flag set. Two that share an edge are taken to meet only there. The tree is of the same triangles; each triangle is tested against those whose boxes its own box overlaps.
std::vector<Crossing> surfaceCrossings(const trace::Bvh& bvh, const trace::WorldTriangles& world,
                                       std::span<const std::uint8_t> objects);

} // namespace shadowlab::shadow_map
