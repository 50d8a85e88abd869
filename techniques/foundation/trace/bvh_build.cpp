// SPDX-License-Identifier: MIT
#include "techniques/foundation/trace/bvh_build.h"

#include <algorithm>
#include <utility>

namespace shadowlab::trace {

namespace {

// More bins cut better and cost more; beyond 16 the trees hardly change (Wald 2007).
constexpr int kBins = 16;
constexpr std::uint32_t kLeafSize = 4; // what triangle_filter.h tests together

// From this depth on nodes are halved by number, which ends after at most 32 levels for 2^32 triangles.
constexpr int kHalvingDepth = Bvh::kMostDepth - 32;

// Nodes between two looks at the clock.
constexpr int kNodesPerSlice = 64;

bool isFinite(const dvec3& p) { return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z); }

} // namespace

BvhBuilder::BvhBuilder(std::vector<Triangle> triangles) {
    bvh_.triangles = std::move(triangles);
    references_.reserve(bvh_.triangles.size());
    for (std::uint32_t i = 0; i < bvh_.triangles.size(); ++i) {
        const Triangle& t = bvh_.triangles[i];
        if (!isFinite(t.a) || !isFinite(t.b) || !isFinite(t.c)) continue;
        Reference reference{.box = {}, .centroid = {}, .primitive = i};
        const dvec3 lower = glm::min(t.a, glm::min(t.b, t.c)), upper = glm::max(t.a, glm::max(t.b, t.c));
        for (int axis = 0; axis < 3; ++axis) {
            reference.box.lower[axis] = roundedDown(lower[axis]);
            reference.box.upper[axis] = roundedUp(upper[axis]);
        }
        reference.centroid = vec3(0.5 * lower + 0.5 * upper);
        references_.push_back(reference);
    }
    if (references_.empty()) return;
    addNode(0, static_cast<std::uint32_t>(references_.size()), 1);
    open_.push_back(0);
}

std::uint32_t BvhBuilder::addNode(std::uint32_t first, std::uint32_t count, int depth) {
    BinaryNode node{.box = {}, .first = first, .count = count, .left = 0, .right = 0, .depth = depth};
    for (std::uint32_t i = first; i < first + count; ++i)
        node.box.include(references_[i].box);
    nodes_.push_back(node);
    return static_cast<std::uint32_t>(nodes_.size() - 1);
}

bool BvhBuilder::advance(std::chrono::steady_clock::time_point deadline) {
    while (!open_.empty()) {
        for (int i = 0; i < kNodesPerSlice && !open_.empty(); ++i) {
            const std::uint32_t index = open_.back();
            open_.pop_back();
            split(index);
        }
        if (!open_.empty() && std::chrono::steady_clock::now() >= deadline) return false;
    }
    if (!std::exchange(folded_, true)) fold();
    return true;
}

double BvhBuilder::done() const {
    return references_.empty() ? 1.0 : static_cast<double>(placed_) / static_cast<double>(references_.size());
}

void BvhBuilder::split(std::uint32_t index) {
    const BinaryNode node = nodes_[index];
    bvh_.depth = std::max(bvh_.depth, node.depth);
    if (node.count <= kLeafSize) {
        placed_ += node.count;
        return;
    }
    const std::uint32_t middle = partition(node);
    const std::uint32_t left = addNode(node.first, middle - node.first, node.depth + 1);
    const std::uint32_t right = addNode(middle, node.first + node.count - middle, node.depth + 1);
    nodes_[index].left = left;
    nodes_[index].right = right;
    open_.push_back(right);
    open_.push_back(left);
}

/// Sorts the node's references into two groups, neither empty, and returns where the second begins.
std::uint32_t BvhBuilder::partition(const BinaryNode& node) {
    const auto begin = references_.begin() + node.first, end = begin + node.count;
    const auto half = begin + node.count / 2;
    vec3 lower(std::numeric_limits<float>::infinity()), upper(-std::numeric_limits<float>::infinity());
    for (auto r = begin; r != end; ++r) {
        lower = glm::min(lower, r->centroid);
        upper = glm::max(upper, r->centroid);
    }
    // Expected work of a cut: the chance that a ray meets a half, its area, times the triangles in it.
    float leastCost = std::numeric_limits<float>::infinity();
    int bestAxis = -1, bestBin = 0;
    const auto binOf = [&](const Reference& r, int axis) {
        const float scale = static_cast<float>(kBins) / (upper[axis] - lower[axis]);
        return std::min(kBins - 1, static_cast<int>((r.centroid[axis] - lower[axis]) * scale));
    };
    for (int axis = 0; axis < 3 && node.depth < kHalvingDepth; ++axis) {
        const float extent = upper[axis] - lower[axis];
        if (!(extent > 0) || !std::isfinite(static_cast<float>(kBins) / extent) || !std::isfinite(extent)) continue;
        std::array<Box, kBins> boxes;
        std::array<std::uint32_t, kBins> counts{};
        for (auto r = begin; r != end; ++r) {
            const auto bin = static_cast<std::size_t>(binOf(*r, axis));
            boxes[bin].include(r->box);
            ++counts[bin];
        }
        std::array<float, kBins> rightCost{}; // of everything from a bin on
        Box box;
        std::uint32_t count = 0;
        for (std::size_t bin = kBins; bin-- > 1;) {
            box.include(boxes[bin]);
            count += counts[bin];
            rightCost[bin] = box.halfArea() * static_cast<float>(count);
        }
        box = {};
        std::uint32_t leftCount = 0;
        for (std::size_t bin = 1; bin < kBins; ++bin) {
            box.include(boxes[bin - 1]);
            leftCount += counts[bin - 1];
            const float cost = box.halfArea() * static_cast<float>(leftCount) + rightCost[bin];
            if (leftCount == 0 || leftCount == node.count || !(cost < leastCost)) continue;
            leastCost = cost;
            bestAxis = axis;
            bestBin = static_cast<int>(bin);
        }
    }
    if (bestAxis >= 0) {
        const auto middle =
            std::partition(begin, end, [&](const Reference& r) { return binOf(r, bestAxis) < bestBin; });
        return static_cast<std::uint32_t>(middle - references_.begin());
    }
    // All centroids in one point, or too deep: half of the triangles to each side, along the longest axis.
    const vec3 extent = upper - lower;
    const int axis = extent.x > extent.y ? (extent.x > extent.z ? 0 : 2) : (extent.y > extent.z ? 1 : 2);
    std::nth_element(begin, half, end, [axis](const Reference& a, const Reference& b) {
        return std::pair(a.centroid[axis], a.primitive) < std::pair(b.centroid[axis], b.primitive);
    });
    return static_cast<std::uint32_t>(half - references_.begin());
}

BvhChild BvhBuilder::foldChild(std::uint32_t index, std::vector<std::pair<std::uint32_t, std::uint32_t>>& open) {
    const BinaryNode& node = nodes_[index];
    if (node.left != 0) {
        const auto wide = static_cast<std::uint32_t>(bvh_.nodes.size());
        bvh_.nodes.emplace_back();
        open.emplace_back(index, wide);
        return BvhChild::node(wide);
    }
    FourTriangles& leaf = bvh_.leaves.emplace_back();
    for (std::uint32_t i = node.first; i < node.first + node.count; ++i)
        leaf.add(bvh_.triangles[references_[i].primitive], references_[i].primitive);
    return BvhChild::leaf(static_cast<std::uint32_t>(bvh_.leaves.size() - 1));
}

/// Binary nodes into nodes of four: the child with the largest box gives way to its own children, until there are four.
void BvhBuilder::fold() {
    if (references_.empty()) return;
    std::vector<std::pair<std::uint32_t, std::uint32_t>> open; // binary node, wide node
    bvh_.nodes.emplace_back();
    open.emplace_back(0, 0);
    while (!open.empty()) {
        const auto [binary, wide] = open.back();
        open.pop_back();
        std::vector<std::uint32_t> children{binary};
        while (children.size() < 4) {
            const auto largest = std::ranges::max_element(
                children, {}, [&](std::uint32_t i) { return nodes_[i].left == 0 ? -1.0f : nodes_[i].box.halfArea(); });
            const BinaryNode& opened = nodes_[*largest];
            if (opened.left == 0) break; // leaves only
            *largest = opened.left;
            children.push_back(opened.right);
        }
        BvhNode node;
        for (std::size_t i = 0; i < 4; ++i) {
            const Box box = i < children.size() ? nodes_[children[i]].box : Box{};
            for (int axis = 0; axis < 3; ++axis) {
                node.boxes.planes[axis][0][i] = box.lower[axis];
                node.boxes.planes[axis][1][i] = box.upper[axis];
            }
            if (i < children.size()) node.children[i] = foldChild(children[i], open);
        }
        bvh_.nodes[wide] = node;
    }
}

Bvh BvhBuilder::take() {
    references_.clear();
    nodes_.clear();
    return std::move(bvh_);
}

Bvh buildBvh(std::vector<Triangle> triangles) {
    BvhBuilder builder(std::move(triangles));
    builder.advance(std::chrono::steady_clock::time_point::max());
    return builder.take();
}

} // namespace shadowlab::trace
