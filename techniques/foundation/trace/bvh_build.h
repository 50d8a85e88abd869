// Building the tree: top down, each box cut where a ray is expected to do the least work.
//
// Binned surface area heuristic (Wald, "On Fast Construction of SAH-based Bounding Volume Hierarchies", 2007) into a
// binary tree, which is then folded into nodes of four. The work can be done in slices.
// SPDX-License-Identifier: MIT
#pragma once
#include <chrono>
#include <span>

#include "techniques/foundation/trace/bvh.h"

namespace shadowlab::trace {

class BvhBuilder {
public:
    /// Triangles with a corner that is not finite are left out: nothing hits them.
    explicit BvhBuilder(std::vector<Triangle> triangles);

    /// Goes on until the tree is finished (true) or the time has come (false), but always a bit.
    bool advance(std::chrono::steady_clock::time_point deadline);
    /// Share of the work that is done, 0..1.
    [[nodiscard]] double done() const;
    /// The finished tree.
    Bvh take();

private:
    struct Box {
        vec3 lower{std::numeric_limits<float>::infinity()}, upper{-std::numeric_limits<float>::infinity()};
        void include(const Box& other) {
            lower = glm::min(lower, other.lower);
            upper = glm::max(upper, other.upper);
        }
        [[nodiscard]] float halfArea() const {
            const vec3 d = upper - lower;
            return d.x < 0 ? 0 : d.x * d.y + d.y * d.z + d.z * d.x;
        }
    };
    struct Reference { ///< a triangle as the builder sees it
        Box box;
        vec3 centroid;
        std::uint32_t primitive;
    };
    struct BinaryNode {
        Box box;
        std::uint32_t first = 0, count = 0; ///< of the references below it
        std::uint32_t left = 0, right = 0;  ///< 0: a leaf (the root is nobody's child)
        int depth = 0;
    };
    void split(std::uint32_t index);
    [[nodiscard]] std::uint32_t partition(const BinaryNode& node);
    std::uint32_t addNode(std::uint32_t first, std::uint32_t count, int depth);
    void fold();
    BvhChild foldChild(std::uint32_t index, std::vector<std::pair<std::uint32_t, std::uint32_t>>& open);

    Bvh bvh_;
    std::vector<Reference> references_;
    std::vector<BinaryNode> nodes_;
    std::vector<std::uint32_t> open_; ///< nodes still to be split
    std::size_t placed_ = 0;          ///< references that have found their leaf
    bool folded_ = false;
};

/// All at once.
Bvh buildBvh(std::vector<Triangle> triangles);

} // namespace shadowlab::trace
