// Closed meshes with all corners on the grid of 2^-10 metres (recipe.h).
// SPDX-License-Identifier: MIT
#pragma once
#include <vector>

#include "techniques/foundation/scene/model/mesh.h"

namespace shadowlab::relations {

using ivec3 = glm::ivec3;
inline constexpr double kGrid = 0x1p-10; ///< metres

/// Corners in steps of the grid; triangles are counter-clockwise seen from outside.
struct Solid {
    std::vector<ivec3> corners;
    std::vector<uvec3> triangles;
};

/// All of these fit into a box of that size around the origin. Sizes are even, so that halves are on the grid, too.
Solid makeBoxSolid(const ivec3& size);
/// An icosahedron, each triangle cut into four, its corners rounded to the grid.
Solid makeBallSolid(const ivec3& size);
/// A star of four to six corners, convex or not, extruded upward and aslant.
Solid makePrismSolid(const ivec3& size, unsigned shape);
/// The convex hull of eight to fourteen points.
Solid makeHullSolid(const ivec3& size, unsigned shape);

/// With flat normals, or smooth ones.
scene::Mesh meshOf(const Solid& solid, bool smooth);

} // namespace shadowlab::relations
