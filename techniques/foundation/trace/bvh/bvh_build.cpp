// SPDX-License-Identifier: MIT
#include "techniques/foundation/trace/bvh/bvh_build.h"

#include <algorithm>
#include <utility>

#include "techniques/foundation/trace/bvh/ray_box.h"
#include "techniques/foundation/trace/parallel.h"

namespace shadowlab::trace {

namespace {

// From this depth on nodes are halved by number, which ends after at most 32 levels for 2^32 triangles.
constexpr int kHalvingDepth = Bvh::kMostDepth - 32;

// A task of no more triangles is finished at once; a larger one is cut in two tasks. This many tasks are done between two
// readings of the clock: some milliseconds.
constexpr std::uint32_t kWholeTask = 256;
constexpr std::size_t kTasksPerSlice = 128;

// Triangles or leaves that a thread takes at a time, and in a slice; fewer triangles are not worth a second thread.
constexpr std::size_t kPiece = 4096, kLeavesPerSlice = std::size_t{1} << 15;
constexpr std::uint32_t kWorthThreads = 1 << 14;

bool isFinite(const dvec3& p) { return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z); }

/// Calls work(from, to) for pieces of a range; on this thread alone where it is short.
template <typename Work>
void inPieces(std::size_t first, std::size_t end, const Work& work) {
    const std::size_t pieces = (end - first + kPiece - 1) / kPiece;
    parallelFor(
        pieces, [&](std::size_t i) { work(first + i * kPiece, std::min(end, first + (i + 1) * kPiece)); },
        (end - first) < kWorthThreads ? 1 : 0);
}

} // namespace

BvhBuilder::BvhBuilder(std::vector<Triangle> triangles) : BvhBuilder(std::move(triangles), {}) {
    triangles_ = bvh_.triangles;
    makeReferences();
}

BvhBuilder::BvhBuilder(std::vector<Triangle> owned, std::span<const Triangle> triangles) : triangles_(triangles) {
    bvh_.triangles = std::move(owned);
    makeReferences();
}

void BvhBuilder::makeReferences() {
    references_.resize(triangles_.size());
    if (triangles_.empty()) return;
    inPieces(0, triangles_.size(), [&](std::size_t from, std::size_t to) {
        for (std::size_t i = from; i < to; ++i) {
            const Triangle& t = triangles_[i];
            SplitReference& reference = references_[i];
            const bool isThere = isFinite(t.a) && isFinite(t.b) && isFinite(t.c);
            reference.none = 0;
            reference.primitive = isThere ? static_cast<std::uint32_t>(i) : kNoPrimitive;
            const dvec3 lower = glm::min(t.a, glm::min(t.b, t.c)), upper = glm::max(t.a, glm::max(t.b, t.c));
            for (int axis = 0; axis < 3; ++axis) {
                reference.lower[axis] = roundedDown(lower[axis]);
                reference.upper[axis] = roundedUp(upper[axis]);
            }
        }
    });
    std::erase_if(references_, [](const SplitReference& r) { return r.primitive == kNoPrimitive; });
    if (references_.empty()) return;
    BinaryNode root;
    Task task;
    for (const SplitReference& reference : references_) {
        root.box.include(reference.box());
        task.centroids.include(reference.centroid());
    }
    root.count = static_cast<std::uint32_t>(references_.size());
    nodes_.push_back(root);
    open_.push_back(task);
}

bool BvhBuilder::advance(std::chrono::steady_clock::time_point deadline) {
    const auto isLate = [&] { return std::chrono::steady_clock::now() >= deadline; };
    while (!open_.empty()) {
        splitSome();
        if (isLate()) return false;
    }
    if (!std::exchange(folded_, true)) fold();
    while (filled_ < ranges_.size()) {
        fillSomeLeaves();
        if (filled_ < ranges_.size() && isLate()) return false;
    }
    return true;
}

double BvhBuilder::done() const {
    if (references_.empty() || (folded_ && filled_ == ranges_.size())) return 1.0;
    // Filling the leaves takes about a tenth of the time.
    const double filled = folded_ ? static_cast<double>(filled_) / static_cast<double>(ranges_.size()) : 0.0;
    return 0.9 * static_cast<double>(placed_) / static_cast<double>(references_.size()) + 0.1 * filled;
}

/// The next few tasks, side by side. Their results are joined in the order of the tasks, so the tree does not depend on the
/// threads.
void BvhBuilder::splitSome() {
    const std::size_t count = std::min(kTasksPerSlice, open_.size());
    const std::vector<Task> tasks(open_.end() - static_cast<std::ptrdiff_t>(count), open_.end());
    open_.resize(open_.size() - count);
    std::uint32_t triangles = 0;
    for (const Task& task : tasks)
        triangles += nodes_[task.node].count;
    std::vector<Subtree> subtrees(count);
    parallelFor(
        count, [&](std::size_t i) { subtrees[i] = splitBelow(tasks[i]); }, triangles < kWorthThreads ? 1 : 0);
    for (std::size_t i = 0; i < count; ++i) {
        Subtree& subtree = subtrees[i];
        bvh_.depth = std::max(bvh_.depth, subtree.depth);
        placed_ += subtree.placed;
        // Nodes of a subtree count from its task's node, which is there already, in place of their first.
        const auto base = static_cast<std::uint32_t>(nodes_.size()) - 1;
        for (BinaryNode& node : subtree.nodes) {
            node.left += node.left ? base : 0;
            node.right += node.right ? base : 0;
        }
        nodes_[tasks[i].node] = subtree.nodes[0];
        nodes_.insert(nodes_.end(), subtree.nodes.begin() + 1, subtree.nodes.end());
        for (Task& task : subtree.open) {
            task.node += base;
            open_.push_back(task);
        }
    }
}

BvhBuilder::Subtree BvhBuilder::splitBelow(const Task& task) {
    Subtree subtree;
    subtree.nodes.push_back(nodes_[task.node]);
    const bool whole = subtree.nodes[0].count <= kWholeTask;
    std::vector<Task> open{{0, task.depth, task.centroids}};
    while (!open.empty()) {
        const Task next = open.back();
        open.pop_back();
        const BinaryNode node = subtree.nodes[next.node];
        subtree.depth = std::max(subtree.depth, next.depth);
        if (node.count <= kLeafTriangles) {
            subtree.placed += node.count;
            continue;
        }
        const Split halves =
            split({&references_[node.first], node.count}, next.centroids, kLeafTriangles, next.depth >= kHalvingDepth);
        const auto left = static_cast<std::uint32_t>(subtree.nodes.size());
        subtree.nodes[next.node].left = left;
        subtree.nodes[next.node].right = left + 1;
        subtree.nodes.push_back({halves.boxes[0], node.first, halves.left});
        subtree.nodes.push_back({halves.boxes[1], node.first + halves.left, node.count - halves.left});
        std::vector<Task>& waiting = whole ? open : subtree.open;
        waiting.push_back({left + 1, next.depth + 1, halves.centroids[1]});
        waiting.push_back({left, next.depth + 1, halves.centroids[0]});
    }
    return subtree;
}

BvhChild BvhBuilder::foldChild(std::uint32_t index, std::vector<std::pair<std::uint32_t, std::uint32_t>>& open) {
    const BinaryNode& node = nodes_[index];
    if (node.left != 0) {
        const auto wide = static_cast<std::uint32_t>(bvh_.nodes.size());
        bvh_.nodes.emplace_back();
        open.emplace_back(index, wide);
        return BvhChild::node(wide);
    }
    ranges_.emplace_back(node.first, node.count);
    return BvhChild::leaf(static_cast<std::uint32_t>(ranges_.size() - 1));
}

/// Binary nodes into nodes of eight: the child with the largest box gives way to its own children, until there are eight.
void BvhBuilder::fold() {
    if (references_.empty()) return;
    std::vector<std::pair<std::uint32_t, std::uint32_t>> open; // binary node, wide node
    bvh_.nodes.emplace_back();
    open.emplace_back(0, 0);
    while (!open.empty()) {
        const auto [binary, wide] = open.back();
        open.pop_back();
        std::array<std::uint32_t, kBvhWidth> children{binary};
        std::array<float, kBvhWidth> areas{nodes_[binary].left == 0 ? -1.0f : nodes_[binary].box.halfArea()};
        int count = 1;
        const auto areaOf = [&](std::uint32_t i) { return nodes_[i].left == 0 ? -1.0f : nodes_[i].box.halfArea(); };
        while (count < kBvhWidth) {
            const auto largest =
                static_cast<std::size_t>(std::max_element(areas.begin(), areas.begin() + count) - areas.begin());
            const BinaryNode& opened = nodes_[children[largest]];
            if (opened.left == 0) break; // leaves only
            children[largest] = opened.left;
            areas[largest] = areaOf(opened.left);
            children[static_cast<std::size_t>(count)] = opened.right;
            areas[static_cast<std::size_t>(count++)] = areaOf(opened.right);
        }
        BvhNode node;
        node.count = count;
        for (int i = 0; i < kBvhWidth; ++i) {
            alignas(16) float lower[4], upper[4];
            const SplitBox box = i < count ? nodes_[children[static_cast<std::size_t>(i)]].box : SplitBox{};
            box.lower.store(lower);
            box.upper.store(upper);
            for (int axis = 0; axis < 3; ++axis) {
                node.planes[axis][0][i] = lower[axis];
                node.planes[axis][1][i] = upper[axis];
                if (i < count) bvh_.largest = std::max({bvh_.largest, std::abs(lower[axis]), std::abs(upper[axis])});
            }
            node.children[i] = (i < count ? foldChild(children[static_cast<std::size_t>(i)], open) : BvhChild()).code();
        }
        bvh_.nodes[wide] = node;
    }
    bvh_.leaves.resize(ranges_.size());
}

void BvhBuilder::fillSomeLeaves() {
    const std::size_t end = std::min(ranges_.size(), filled_ + kLeavesPerSlice);
    inPieces(filled_, end, [&](std::size_t from, std::size_t to) {
        for (std::size_t l = from; l < to; ++l) {
            BvhLeaf& leaf = bvh_.leaves[l];
            const auto [first, count] = ranges_[l];
            leaf.count = static_cast<std::int32_t>(count);
            leaf.largest = 0;
            for (std::uint32_t i = 0; i < kLeafTriangles; ++i) {
                const SplitReference& reference = references_[first + (i < count ? i : 0)];
                leaf.primitives[i] = reference.primitive;
                const Triangle& triangle = triangles_[reference.primitive];
                const dvec3* const corners[3] = {&triangle.a, &triangle.b, &triangle.c};
                for (int corner = 0; corner < 3; ++corner)
                    for (int axis = 0; axis < 3; ++axis)
                        leaf.corners[corner][axis][i] = (*corners[corner])[axis];
                for (int axis = 0; axis < 3; ++axis)
                    leaf.largest =
                        std::max({leaf.largest, std::abs(reference.lower[axis]), std::abs(reference.upper[axis])});
            }
        }
    });
    filled_ = end;
}

Bvh BvhBuilder::take() {
    references_ = {};
    nodes_ = {};
    ranges_ = {};
    return std::move(bvh_);
}

Bvh buildBvh(std::vector<Triangle> triangles) {
    BvhBuilder builder(std::move(triangles));
    builder.advance(std::chrono::steady_clock::time_point::max());
    return builder.take();
}

} // namespace shadowlab::trace
