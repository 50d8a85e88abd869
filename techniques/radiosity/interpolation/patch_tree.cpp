// SPDX-License-Identifier: MIT
#include "techniques/radiosity/interpolation/patch_tree.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace shadowlab::radiosity {

namespace {

// So many edges, evenly chosen, are tried as splitting lines; all edges where each of these cuts a polygon. Patches are made by
// cutting, so some line always separates them cleanly.
constexpr std::size_t kTries = 64;

double height(const dvec3& line, const dvec2& p) { return line.x * p.x + line.y * p.y + line.z; }

struct Parts {
    std::vector<const FlatPolygon*> front, behind;
    std::size_t cut = 0; ///< polygons on both sides, which are in both lists
    /// The cost of a line: fewer cuts are better, then halves of equal size.
    [[nodiscard]] std::size_t badness(std::size_t all) const {
        return cut * 2 * all + std::max(front.size(), behind.size());
    }
};

Parts partedBy(const dvec3& line, std::span<const FlatPolygon* const> polygons, double touching) {
    Parts parts;
    for (const FlatPolygon* polygon : polygons) {
        double lowest = std::numeric_limits<double>::infinity(), highest = -lowest;
        for (const dvec2& corner : polygon->corners) {
            lowest = std::min(lowest, height(line, corner));
            highest = std::max(highest, height(line, corner));
        }
        const bool isFront = highest > touching, isBehind = lowest < -touching;
        parts.cut += isFront && isBehind;
        // A sliver within the tolerance of the line goes to the side where most of it is.
        if (isFront || (!isBehind && highest > -lowest)) parts.front.push_back(polygon);
        if (isBehind || (!isFront && highest <= -lowest)) parts.behind.push_back(polygon);
    }
    return parts;
}

std::optional<dvec3> lineOf(const FlatPolygon& polygon, std::size_t edge, double touching) {
    const dvec2 &a = polygon.corners[edge], &b = polygon.corners[(edge + 1) % polygon.corners.size()];
    const dvec2 along = b - a;
    const double length = glm::length(along);
    if (length <= touching) return std::nullopt;
    const dvec2 normal = dvec2(-along.y, along.x) / length;
    return dvec3(normal, -glm::dot(normal, a));
}

std::uint32_t build(PatchTree& tree, const std::vector<const FlatPolygon*>& polygons, double touching) {
    if (polygons.size() == 1) return PatchTree::kLeaf | polygons.front()->number;
    std::size_t edges = 0;
    for (const FlatPolygon* polygon : polygons)
        edges += polygon->corners.size();
    std::optional<dvec3> best;
    Parts bestParts;
    const auto tryEvery = [&](std::size_t step) {
        std::size_t edge = 0, next = 0;
        for (const FlatPolygon* polygon : polygons)
            for (std::size_t i = 0; i < polygon->corners.size(); ++i, ++edge) {
                if (edge != next) continue;
                next += step;
                const auto line = lineOf(*polygon, i, touching);
                if (!line) continue;
                Parts parts = partedBy(*line, polygons, touching);
                if (parts.front.size() == polygons.size() || parts.behind.size() == polygons.size()) continue;
                if (best && parts.badness(polygons.size()) >= bestParts.badness(polygons.size())) continue;
                best = line;
                bestParts = std::move(parts);
            }
    };
    const std::size_t step = std::max<std::size_t>(1, edges / kTries);
    tryEvery(step);
    if (step > 1 && (!best || bestParts.cut > 0)) tryEvery(1);
    if (!best) return PatchTree::kLeaf | polygons.front()->number; // the polygons overlap
    const auto node = static_cast<std::uint32_t>(tree.nodes.size());
    tree.nodes.push_back({*best, 0, 0});
    const std::uint32_t front = build(tree, bestParts.front, touching),
                        behind = build(tree, bestParts.behind, touching);
    tree.nodes[node].front = front;
    tree.nodes[node].behind = behind;
    return node;
}

} // namespace

std::uint32_t addTree(PatchTree& tree, std::span<const FlatPolygon> polygons, double touching) {
    std::vector<const FlatPolygon*> all;
    for (const FlatPolygon& polygon : polygons)
        all.push_back(&polygon);
    return build(tree, all, touching);
}

std::uint32_t find(const PatchTree& tree, std::uint32_t root, const dvec2& point) {
    while ((root & PatchTree::kLeaf) == 0) {
        const PatchTree::Node& node = tree.nodes[root];
        root = height(node.line, point) > 0 ? node.front : node.behind;
    }
    return root & ~PatchTree::kLeaf;
}

} // namespace shadowlab::radiosity
