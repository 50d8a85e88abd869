// A tree of bounding spheres: each holds all triangles below it, its two children half of them each (Rubin and Whitted,
// 1980; Rusinkiewicz and Levoy, "QSplat", SIGGRAPH 2000, for a tree cut in halves).
//
// Halving by number makes every branch as long as every other, whatever the triangles: 2^32 of them are 32 levels. This
// tree is slow in comparison: spheres fit flat objects badly, and halving by number ignores the extent of the triangles.
// Compared with bvh_build.h it shows what boxes and the surface area heuristic gain.
// SPDX-License-Identifier: MIT
#include <array>

#include "techniques/foundation/trace/ray_query.h"
#include "techniques/foundation/trace/structures/ray_volumes.h"

namespace shadowlab::trace {

namespace {

constexpr std::uint32_t kLeafSize = 4;
constexpr std::size_t kMostDepth = 64; // 2^32 triangles, halved, are 32 deep; each level leaves one child waiting
constexpr int kNodesPerSlice = 64;     // between two readings of the clock

class SphereTree final : public WalkingEngine<SphereTree> {
public:
    explicit SphereTree(const EngineInput& input)
        : WalkingEngine(input), order_(finiteTriangles(input.triangles, 0, input.triangles.size())) {
        if (order_.empty()) return;
        nodes_.push_back({.ball = {}, .first = 0, .count = static_cast<std::uint32_t>(order_.size())});
        open_.push_back(0);
    }

    bool advance(Deadline deadline) override {
        while (!open_.empty()) {
            for (int i = 0; i < kNodesPerSlice && !open_.empty(); ++i) {
                const std::uint32_t node = open_.back();
                open_.pop_back();
                split(node);
            }
            if (!open_.empty() && std::chrono::steady_clock::now() >= deadline) return false;
        }
        return true;
    }
    [[nodiscard]] double done() const override {
        return order_.empty() ? 1.0 : static_cast<double>(placed_) / static_cast<double>(order_.size());
    }

    template <typename Query, typename Count>
    void visit(const Ray&, Query& query, Count count) const {
        if (nodes_.empty()) return;
        const VolumeRay ray(query.sheared);
        struct Entry {
            std::uint32_t node;
            double enter; ///< where the ray enters its sphere
        };
        std::array<Entry, kMostDepth> stack;
        std::size_t size = 0;
        count.volumes(1);
        if (const double enter = ray.enter(nodes_[0].ball, query.farthest()); enter != kNowhere)
            stack[size++] = {0, enter};
        while (size > 0) {
            const Entry entry = stack[--size];
            if (entry.enter > query.farthest()) continue; // something nearer was found in the meantime
            count.step();
            const Node& node = nodes_[entry.node];
            if (node.left == 0) {
                for (std::uint32_t i = node.first; i < node.first + node.count; ++i) {
                    count.triangles(1);
                    query.tryTriangle(order_[i]);
                    if (query.isAnswered()) return;
                }
                continue;
            }
            // The children lie side by side. The nearer one is looked into first: it goes on top.
            count.volumes(2);
            Entry near{node.left, ray.enter(nodes_[node.left].ball, query.farthest())};
            Entry far{node.left + 1, ray.enter(nodes_[node.left + 1].ball, query.farthest())};
            if (far.enter < near.enter) std::swap(near, far);
            if (far.enter != kNowhere) stack[size++] = far;
            if (near.enter != kNowhere) stack[size++] = near;
        }
    }

    [[nodiscard]] std::size_t bytes() const override {
        return nodes_.size() * sizeof(Node) + order_.size() * sizeof(order_[0]);
    }
    [[nodiscard]] std::vector<StructurePart> parts(std::size_t most) const override {
        std::vector<StructurePart> parts;
        struct Open {
            std::uint32_t node;
            int parent;
        };
        std::vector<Open> level;
        if (!nodes_.empty()) level.push_back({0, -1});
        for (int depth = 0; !level.empty() && level.size() <= most; ++depth) {
            std::vector<Open> below;
            for (const auto& [index, parent] : level) {
                const Node& node = nodes_[index];
                const int place = static_cast<int>(parts.size());
                parts.push_back({true, depth, {}, {}, node.ball.centreCentred, node.ball.radius, parent});
                if (node.left != 0) below.insert(below.end(), {{node.left, place}, {node.left + 1, place}});
            }
            level = std::move(below);
        }
        return parts;
    }

private:
    struct Node {
        Ball ball;
        std::uint32_t first, count; ///< of the order
        std::uint32_t left = 0;     ///< the right child follows it; 0: a leaf (node 0 is the root, never a child)
    };

    [[nodiscard]] dvec3 middle(std::uint32_t primitive) const {
        const Triangle& t = input_.triangles[primitive];
        return (t.a + t.b + t.c) / 3.0;
    }

    void split(std::uint32_t index) {
        const Node node = nodes_[index];
        const auto begin = order_.begin() + node.first, end = begin + node.count;
        nodes_[index].ball = ballAround(input_.triangles, std::span(begin, end));
        if (node.count <= kLeafSize) {
            placed_ += node.count;
            return;
        }
        Box middles;
        for (auto p = begin; p != end; ++p)
            middles.include(middle(*p));
        const dvec3 extent = middles.upperCentred - middles.lowerCentred;
        const int axis = extent.x > extent.y ? (extent.x > extent.z ? 0 : 2) : (extent.y > extent.z ? 1 : 2);
        const std::uint32_t half = node.count / 2;
        std::nth_element(begin, begin + half, end, [&](std::uint32_t a, std::uint32_t b) {
            return std::pair(middle(a)[axis], a) < std::pair(middle(b)[axis], b);
        });
        const auto left = static_cast<std::uint32_t>(nodes_.size());
        nodes_[index].left = left;
        nodes_.push_back({.ball = {}, .first = node.first, .count = half});
        nodes_.push_back({.ball = {}, .first = node.first + half, .count = node.count - half});
        open_.push_back(left + 1);
        open_.push_back(left);
    }

    std::vector<Node> nodes_;
    std::vector<std::uint32_t> order_; ///< the triangles; those of a node one after the other
    std::vector<std::uint32_t> open_;  ///< nodes still to be split
    std::size_t placed_ = 0;           ///< triangles that have found their leaf
};

} // namespace

std::unique_ptr<Engine> makeSphereTree(const EngineInput& input) { return std::make_unique<SphereTree>(input); }

} // namespace shadowlab::trace
