// The order in which the triangles of a mesh stand.
//
// Who draws a mesh transforms a corner once for all triangles that follow soon, and again when it has been forgotten: after some tens of
// others. So triangles that share corners should follow one another. The measure is the mean number of corners that have to be
// transformed for a triangle: between a half, which is the least a large closed mesh can have, and 3 (H. Hoppe, "Optimization of Mesh
// Locality for Transparent Vertex Caching", SIGGRAPH 1999). Modellers write meshes row by row, about 1; what was scanned or simplified
// stands in any order, 2 and more.
// Simplified: triangles are sorted along a curve that fills space, which gives 0.7 to 0.9. Orders that follow the mesh reach 0.6.
// SPDX-License-Identifier: MIT
#pragma once
#include <span>

#include "techniques/foundation/scene/model/mesh.h"

namespace shadowlab::scene {

/// Corners that have to be transformed for a triangle, in the mean, where the last 32 that were are kept. Equal numbers are one corner.
double transformedPerTriangle(std::span<const uvec3> triangles);

/// Sorts the triangles of a large mesh that stands in a bad order, part by part, by their places in space, if that helps, and its vertices by
/// their first use; `fileOrder` says where triangles stood. Corners at one place count as one, as in passes that draw depths alone.
void keepNeighboursTogether(Mesh& mesh);

} // namespace shadowlab::scene
