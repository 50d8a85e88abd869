// SPDX-License-Identifier: MIT
#include "techniques/foundation/trace/block_tree.h"

#include <algorithm>
#include <cmath>

namespace shadowlab::trace {

BlockTree::BlockTree(const Bvh& bvh) {
    nodes_.reserve(bvh.nodes.size());
    for (const BvhNode& node : bvh.nodes) {
        BlockNode& to = nodes_.emplace_back();
        for (int axis = 0; axis < 3; ++axis)
            for (int side = 0; side < 2; ++side)
                for (int i = 0; i < 4; ++i) {
                    const float plane = node.boxes.planes[axis][side][i];
                    to.planes[axis][side][i] = plane;
                    if (std::isfinite(plane)) largest_ = std::max(largest_, std::abs(plane));
                }
        for (std::size_t i = 0; i < 4; ++i) {
            const bool isThere = node.boxes.planes[0][0][i] <= node.boxes.planes[0][1][i];
            const BvhChild child = isThere ? node.children[i] : BvhChild::leaf(0); // inside out: never touched
            to.children[i] =
                child.isLeaf() ? ~static_cast<std::int32_t>(child.index()) : static_cast<std::int32_t>(child.index());
        }
    }
    leaves_.reserve(bvh.leaves.size());
    for (const FourTriangles& four : bvh.leaves) {
        BlockLeaf& to = leaves_.emplace_back();
        to.count = static_cast<std::uint32_t>(four.count);
        for (std::uint32_t i = 0; i < 4; ++i) {
            to.primitives[i] = four.primitives[i < to.count ? i : 0];
            const Triangle& triangle = bvh.triangles[to.primitives[i]];
            const dvec3* const corners[3] = {&triangle.a, &triangle.b, &triangle.c};
            for (int corner = 0; corner < 3; ++corner)
                for (int axis = 0; axis < 3; ++axis)
                    to.corners[corner][axis][i] = (*corners[corner])[axis];
        }
    }
}

} // namespace shadowlab::trace
