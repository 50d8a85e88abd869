// Which patch of a face does a point lie in? A tree of lines answers after a few questions, whatever the patches' shapes are: to
// which side of this line? (H. Fuchs, Z. Kedem and B. Naylor, "On Visible Surface Generation by A Priori Tree Structures",
// SIGGRAPH 1980, of which this is the plane case.)
//
// So a picture shows the borders of patches exactly, however near the eye comes, and needs no texture in which they would be cut to
// texels.
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
    /// A node, or with this bit the number of a polygon.
    static constexpr std::uint32_t kLeaf = 0x80000000u;
    struct Node {
        dvec3 line; ///< in front where line.x * x + line.y * y + line.z > 0; (line.x, line.y) is unit
        std::uint32_t front, behind;
    };
    std::vector<Node> nodes;
};

/// Adds the tree of polygons that do not overlap, at least one; returns its root, a node or a leaf. Of points in none of them the
/// answer is one near by. `touching`: what is nearer than that to a line does not reach beyond it.
std::uint32_t addTree(PatchTree& tree, std::span<const FlatPolygon> polygons, double touching);

/// The number of the polygon that the point lies in.
std::uint32_t find(const PatchTree& tree, std::uint32_t root, const dvec2& point);

} // namespace shadowlab::radiosity
