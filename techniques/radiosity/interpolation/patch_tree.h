// Finds the patch of a face that contains a point, by a binary space partition of the face's plane (H. Fuchs, Z. Kedem and B.
// Naylor, "On Visible Surface Generation by A Priori Tree Structures", SIGGRAPH 1980; this is the two-dimensional case).
//
// The borders of patches are then exact in a picture, however near the eye is; a texture would show its texels.
// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "techniques/foundation/math/types.h"

namespace shadowlab::radiosity {

/// A convex polygon in the plane of a face, and its number.
struct FlatPolygon {
    std::vector<dvec2> corners; ///< counter-clockwise
    std::uint32_t number = 0;
};

struct PatchTree {
    /// The number of a node, or, with this bit, of a polygon.
    static constexpr std::uint32_t kLeaf = 0x80000000u;
    struct Node {
        dvec3 line; ///< in front where line.x * x + line.y * y + line.z > 0; (line.x, line.y) is unit
        std::uint32_t front, behind;
    };
    std::vector<Node> nodes;
};

/// Adds the tree of polygons that do not overlap, at least one; returns its root, a node or a leaf. Points in no polygon are
/// assigned to one near by. `touching`: the tolerance; what is nearer than that to a line does not count as beyond it.
std::uint32_t addTree(PatchTree& tree, std::span<const FlatPolygon> polygons, double touching);

/// The number of the polygon that contains the point.
std::uint32_t find(const PatchTree& tree, std::uint32_t root, const dvec2& point);

} // namespace shadowlab::radiosity
