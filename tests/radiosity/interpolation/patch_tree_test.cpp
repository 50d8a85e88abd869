// SPDX-License-Identifier: MIT
#include "techniques/radiosity/interpolation/patch_tree.h"

#include <gtest/gtest.h>

#include <random>

namespace shadowlab::radiosity {
namespace {

bool isInside(const FlatPolygon& polygon, const dvec2& p, double margin) {
    for (std::size_t i = 0; i < polygon.corners.size(); ++i) {
        const dvec2 a = polygon.corners[i], way = polygon.corners[(i + 1) % polygon.corners.size()] - a;
        if (way.x * (p.y - a.y) - way.y * (p.x - a.x) < margin * glm::length(way)) return false;
    }
    return true;
}

/// A polygon cut along a line, again and again, as patches are.
std::vector<FlatPolygon> cutAtRandom(std::size_t count, std::mt19937& random) {
    std::vector<FlatPolygon> all = {{{{0, 0}, {3, 0}, {3, 2}, {0, 2}}, 0}};
    std::uniform_real_distribution<double> unit(0, 1);
    while (all.size() < count) {
        const std::size_t chosen = random() % all.size();
        const FlatPolygon whole = all[chosen];
        const std::size_t n = whole.corners.size(), first = random() % n, second = (first + 1 + random() % (n - 1)) % n;
        const auto onEdge = [&](std::size_t i) {
            return glm::mix(whole.corners[i], whole.corners[(i + 1) % n], 0.2 + 0.6 * unit(random));
        };
        const dvec2 from = onEdge(first), to = onEdge(second);
        FlatPolygon left{{from}, 0}, right{{to}, 0};
        for (std::size_t i = (first + 1) % n;; i = (i + 1) % n) {
            left.corners.push_back(whole.corners[i]);
            if (i == second) break;
        }
        left.corners.push_back(to);
        for (std::size_t i = (second + 1) % n;; i = (i + 1) % n) {
            right.corners.push_back(whole.corners[i]);
            if (i == first) break;
        }
        right.corners.push_back(from);
        all[chosen] = left;
        all.push_back(right);
    }
    for (std::size_t i = 0; i < all.size(); ++i)
        all[i].number = static_cast<std::uint32_t>(7 * i); // numbers are the caller's own
    return all;
}

std::size_t expectAllFound(const std::vector<FlatPolygon>& polygons, std::mt19937& random) {
    PatchTree tree;
    tree.nodes.push_back({dvec3(1, 0, 0), PatchTree::kLeaf, PatchTree::kLeaf}); // somebody else's tree stays
    const std::uint32_t root = addTree(tree, polygons, 1e-7);
    std::uniform_real_distribution<double> unit(0, 1);
    std::size_t compared = 0;
    for (int i = 0; i < 4000; ++i) {
        const dvec2 p(3 * unit(random), 2 * unit(random));
        for (const FlatPolygon& polygon : polygons)
            if (isInside(polygon, p, 1e-6)) { // borders belong to either
                EXPECT_EQ(find(tree, root, p), polygon.number) << p.x << ", " << p.y;
                ++compared;
            }
    }
    return compared;
}

TEST(PatchTree, FindsThePatchOfEveryPoint) {
    std::mt19937 random(1);
    for (const std::size_t count : {1u, 2u, 3u, 20u, 300u})
        EXPECT_GT(expectAllFound(cutAtRandom(count, random), random), 3900u);
}

TEST(PatchTree, OfAGridTheTreeIsBalanced) {
    std::vector<FlatPolygon> grid;
    constexpr int kSide = 32;
    for (int y = 0; y < kSide; ++y)
        for (int x = 0; x < kSide; ++x) {
            const dvec2 a = dvec2(3.0 * x, 2.0 * y) / double(kSide),
                        b = dvec2(3.0 * (x + 1), 2.0 * (y + 1)) / double(kSide);
            grid.push_back({{a, {b.x, a.y}, b, {a.x, b.y}}, static_cast<std::uint32_t>(grid.size())});
        }
    PatchTree tree;
    const std::uint32_t root = addTree(tree, grid, 1e-7);
    EXPECT_EQ(tree.nodes.size(), grid.size() - 1) << "no polygon is cut";
    // Ten questions tell 1024 apart at best; halves are not always equal, as only some of the lines are samples.
    const auto depth = [&](auto&& self, std::uint32_t node) -> int {
        if (node & PatchTree::kLeaf) return 0;
        return 1 + std::max(self(self, tree.nodes[node].front), self(self, tree.nodes[node].behind));
    };
    EXPECT_LE(depth(depth, root), 14);
    std::mt19937 random(2);
    EXPECT_GT(expectAllFound(grid, random), 3900u);
}

TEST(PatchTree, PatchesThatNoLinePartsAreStillFound) {
    // A windmill: every line along an edge cuts one of the five.
    const std::vector<FlatPolygon> mill = {{{{0, 0}, {2, 0}, {2, 0.5}, {0, 0.5}}, 0},
                                           {{{2, 0}, {3, 0}, {3, 1.5}, {2, 1.5}}, 1},
                                           {{{1, 1.5}, {3, 1.5}, {3, 2}, {1, 2}}, 2},
                                           {{{0, 0.5}, {1, 0.5}, {1, 2}, {0, 2}}, 3},
                                           {{{1, 0.5}, {2, 0.5}, {2, 1.5}, {1, 1.5}}, 4}};
    std::mt19937 random(3);
    EXPECT_GT(expectAllFound(mill, random), 3900u);
}

} // namespace
} // namespace shadowlab::radiosity
