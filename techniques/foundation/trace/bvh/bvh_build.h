// Building the tree: top down, each box cut where a ray is expected to do the least work.
//
// Binned surface area heuristic (Wald, "On Fast Construction of SAH-based Bounding Volume Hierarchies", 2007) into a
// binary tree, which is then folded into nodes of eight. The work can be done in slices, and parts of the tree are made on
// several threads; the tree is the same whatever the slices and the threads.
// SPDX-License-Identifier: MIT
#pragma once
#include <chrono>
#include <span>

#include "techniques/foundation/trace/bvh/bvh.h"
#include "techniques/foundation/trace/bvh/bvh_split.h"

namespace shadowlab::trace {

class BvhBuilder {
public:
    /// Triangles with a corner that is not finite are left out: nothing hits them.
    explicit BvhBuilder(std::vector<Triangle> triangles);
    /// The same without a copy of the triangles, which must outlive the builder: Bvh::triangles stays empty.
    static BvhBuilder over(std::span<const Triangle> triangles) { return BvhBuilder({}, triangles); }

    /// Goes on until the tree is finished (true) or the time has come (false), but always a bit.
    bool advance(std::chrono::steady_clock::time_point deadline);
    /// Share of the work that is done, 0..1.
    [[nodiscard]] double done() const;
    /// The finished tree.
    Bvh take();

private:
    struct BinaryNode {
        SplitBox box;
        std::uint32_t first = 0, count = 0; ///< of the references below it
        std::uint32_t left = 0, right = 0;  ///< children; 0: a leaf (node 0 is the root, never a child)
    };
    struct Task { ///< a node still to be split, and all below it
        std::uint32_t node = 0;
        int depth = 1;
        SplitBox centroids;
    };
    struct Subtree { ///< what became of a task: its nodes below, and those of them that are tasks again
        std::vector<BinaryNode> nodes;
        std::vector<Task> open;
        std::uint32_t placed = 0;
        int depth = 0;
    };
    BvhBuilder(std::vector<Triangle> owned, std::span<const Triangle> triangles);
    void makeReferences();
    void splitSome();
    [[nodiscard]] Subtree splitBelow(const Task& task);
    void fold();
    BvhChild foldChild(std::uint32_t index, std::vector<std::pair<std::uint32_t, std::uint32_t>>& open);
    void fillSomeLeaves();

    Bvh bvh_;
    std::span<const Triangle> triangles_;
    BigVector<SplitReference> references_;
    std::vector<BinaryNode> nodes_;
    std::vector<Task> open_;
    std::size_t placed_ = 0;                                      ///< references that have found their leaf
    std::vector<std::pair<std::uint32_t, std::uint32_t>> ranges_; ///< of each leaf: first reference, count
    std::size_t filled_ = 0;                                      ///< leaves that have their triangles
    bool folded_ = false;
};

/// All at once.
Bvh buildBvh(std::vector<Triangle> triangles);

} // namespace shadowlab::trace
