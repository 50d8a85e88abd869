// The region between two boxes: the shaft of Haines and Wallace, "Shaft Culling for Efficient Ray-Traced Radiosity", EGWR
// 1991. Nothing outside of it lies between a point of one box and a point of the other.
// SPDX-License-Identifier: MIT
#pragma once
#include <limits>
#include <vector>

#include "techniques/foundation/trace/bvh/bvh.h"

namespace shadowlab::trace {

// Lower than this share of the light's distance above a point's plane, a triangle is in that plane: rounding of coordinates is
// a thousand times smaller, and what it could hide of the light no larger.
constexpr double kInPlane = 1e-12;

/// Axis-aligned, in centred space.
struct CentredBox {
    dvec3 lower{std::numeric_limits<double>::infinity()}, upper{-std::numeric_limits<double>::infinity()};
    void include(const dvec3& positionCentred) {
        lower = glm::min(lower, positionCentred);
        upper = glm::max(upper, positionCentred);
    }
    void grow(double metres) {
        lower -= metres;
        upper += metres;
    }
    [[nodiscard]] bool touches(const CentredBox& other) const {
        return glm::all(glm::lessThanEqual(lower, other.upper)) && glm::all(glm::lessThanEqual(other.lower, upper));
    }
};

CentredBox boxOf(const Triangle& triangle);
/// A vector toward its front, as long as twice its area.
inline dvec3 frontOf(const Triangle& t) { return glm::cross(t.b - t.a, t.c - t.a); }

class Shaft {
public:
    Shaft(const CentredBox& from, const CentredBox& to);

    /// False: certainly not within the shaft.
    [[nodiscard]] bool mayTouch(const CentredBox& box) const;
    [[nodiscard]] bool mayTouch(const Triangle& triangle) const;
    /// The straight line between two places.
    [[nodiscard]] bool mayTouch(const dvec3& firstCentred, const dvec3& secondCentred) const;

    /// The triangles that may touch it and that `accept(primitive)` is true of.
    template <typename Accept>
    [[nodiscard]] std::vector<std::uint32_t> triangles(const Bvh& bvh, const Accept& accept) const;

private:
    /// Outside is where the product with the normal is larger than the offset.
    struct Side {
        dvec3 normal;
        double offset;
    };
    CentredBox hull_;
    std::vector<Side> sides_;
};

template <typename Accept>
std::vector<std::uint32_t> Shaft::triangles(const Bvh& bvh, const Accept& accept) const {
    std::vector<std::uint32_t> found;
    if (bvh.nodes.empty()) return found;
    std::vector<BvhChild> waiting{BvhChild::node(0)};
    while (!waiting.empty()) {
        const BvhChild child = waiting.back();
        waiting.pop_back();
        if (child.isLeaf()) {
            const BvhLeaf& leaf = bvh.leaves[child.index()];
            for (int i = 0; i < leaf.count; ++i)
                if (accept(leaf.primitives[i]) && mayTouch(triangleOf(leaf, i))) found.push_back(leaf.primitives[i]);
            continue;
        }
        const BvhNode& node = bvh.nodes[child.index()];
        for (int i = 0; i < node.count; ++i) {
            CentredBox box;
            for (int axis = 0; axis < 3; ++axis) {
                box.lower[axis] = static_cast<double>(node.planes[axis][0][i]);
                box.upper[axis] = static_cast<double>(node.planes[axis][1][i]);
            }
            if (mayTouch(box)) waiting.push_back(BvhChild(node.children[i]));
        }
    }
    return found;
}

} // namespace shadowlab::trace
