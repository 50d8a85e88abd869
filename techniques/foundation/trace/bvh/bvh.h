// A bounding volume hierarchy: boxes in boxes, triangles in the smallest. A ray looks only into boxes it touches.
//
// A node has up to eight children, whose boxes are tested together; a leaf has up to four triangles, likewise. Built by
// BvhBuilder, asked with bvh_traverse.h; both are iterative, and the depth is bounded.
// Kay and Kajiya, "Ray Tracing Complex Scenes", SIGGRAPH 1986; wide nodes after Dammertz, Hanika and Keller,
// "Shallow Bounding Volume Hierarchies for Fast SIMD Ray Tracing of Incoherent Rays", EGSR 2008.
// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "techniques/foundation/trace/bvh/big_memory.h"
#include "techniques/foundation/trace/bvh/bvh_walk.h"
#include "techniques/foundation/trace/ray.h"
#include "techniques/foundation/trace/ray_triangle.h"

namespace shadowlab::trace {

/// What a child of a node means.
class BvhChild {
public:
    static BvhChild node(std::uint32_t index) { return BvhChild(static_cast<std::int32_t>(index)); }
    static BvhChild leaf(std::uint32_t index) { return BvhChild(~static_cast<std::int32_t>(index)); }
    /// As BvhNode stores it.
    explicit BvhChild(std::int32_t code = 0) : code_(code) {}
    [[nodiscard]] std::int32_t code() const { return code_; }
    [[nodiscard]] bool isLeaf() const { return code_ < 0; }
    [[nodiscard]] std::uint32_t index() const { return static_cast<std::uint32_t>(isLeaf() ? ~code_ : code_); }

private:
    std::int32_t code_;
};

inline Triangle triangleOf(const BvhLeaf& leaf, int i) {
    const auto corner = [&](int c) {
        return dvec3(leaf.corners[c][0][i], leaf.corners[c][1][i], leaf.corners[c][2][i]);
    };
    return {corner(0), corner(1), corner(2)};
}

/// No triangle has holes.
struct NoHoles {
    bool operator()(std::uint32_t, const dvec3&) const { return false; }
};

struct Bvh {
    /// No branch is longer than this, whatever the triangles (a hundred thousand equal ones, say): a stack of fixed
    /// size is enough.
    static constexpr int kMostDepth = 64;

    BigVector<BvhNode> nodes; ///< the first is the root; none at all without triangles
    BigVector<BvhLeaf> leaves;
    std::vector<Triangle>
        triangles;     ///< as given: a primitive's id is its index. Rays do without: leaves hold them, too
    float largest = 0; ///< of all coordinates of the boxes, without sign
    int depth = 0;     ///< of the binary tree that nodes of eight were made from
    const BvhKernels* kernels = &bestBvhKernels(); ///< the answers are the same with all of them

    /// The nearest hit; of equally near ones that of the lowest primitive, so that no answer depends on how the tree was
    /// built. `accept(primitive)` is true if this one may be hit; `inHole(primitive, weights of the corners)` is true if
    /// the ray passes through the triangle there. `count` is told what is tried (ray.h).
    template <typename Accept, typename InHole = NoHoles, typename Count = CountNothing>
    [[nodiscard]] RayHit closest(const Ray& ray, const Accept& accept, const InHole& inHole = {},
                                 Count count = {}) const;
    [[nodiscard]] RayHit closest(const Ray& ray) const;

    /// Some hit before ray.farthest, or kNoPrimitive: stops at the first it finds.
    template <typename Accept, typename InHole = NoHoles, typename Count = CountNothing>
    [[nodiscard]] std::uint32_t any(const Ray& ray, const Accept& accept, const InHole& inHole = {},
                                    Count count = {}) const;
};

} // namespace shadowlab::trace
