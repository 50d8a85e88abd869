// Tests whether a surface is certain not to intersect itself, other than where its triangles share an edge or a corner.
//
// A closed surface without self-intersection has only an inside and an outside: its winding number is 0 and 1, or 0 and -1.
// For each pair of triangles whose boxes overlap a plane is looked for that has one on either side (separating axes:
// Gottschalk, Lin and Manocha, "OBBTree", 1996); all pairs that could meet are found with a grid, so it takes time in
// proportion to the number of triangles. Cases too close to decide count as intersections.
// SPDX-License-Identifier: MIT
#pragma once
#include <span>

#include "techniques/foundation/scene/query/topology/mesh_topology.h"

namespace shadowlab::scene {

/// `triangles` are those of the surface, numbers in the mesh. Conservative: also false for surfaces that would take too
/// long to test, with long slanting triangles or triangles of very different sizes.
bool isCertainlySimple(const Mesh& mesh, const MeshTopology& topology, std::span<const std::uint32_t> triangles);

} // namespace shadowlab::scene
