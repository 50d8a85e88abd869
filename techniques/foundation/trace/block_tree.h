// The tree once more, laid out for blocks of rays: plain arrays, the triangles' corners in double and side by side.
// SPDX-License-Identifier: MIT
#pragma once
#include <vector>

#include "techniques/foundation/trace/block_rays.h"
#include "techniques/foundation/trace/bvh.h"

namespace shadowlab::trace {

class BlockTree {
public:
    BlockTree() = default;
    explicit BlockTree(const Bvh& bvh);
    /// Without a node there is nothing to hit, and nothing to ask.
    [[nodiscard]] bool isEmpty() const { return nodes_.empty(); }
    /// `perforated`: as in BlockTreeView.
    [[nodiscard]] BlockTreeView view(const std::uint8_t* perforated = nullptr) const {
        return {nodes_.data(), leaves_.data(), largest_, perforated};
    }

private:
    std::vector<BlockNode> nodes_;
    std::vector<BlockLeaf> leaves_;
    float largest_ = 0;
};

} // namespace shadowlab::trace
