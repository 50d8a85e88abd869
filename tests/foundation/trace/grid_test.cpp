// The grid's walk where it is hard: through edges and corners of cells, where two or three planes are crossed at once. And
// what happens without its safeguards.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "techniques/foundation/trace/parallel.h"
#include "techniques/foundation/trace/structures/grid.h"
#include "tests/foundation/trace/ray_meshes.h"

namespace shadowlab::trace {
namespace {

using namespace shadowlab::testing;

Grid gridOf(const Triangles& triangles) {
    Grid grid({triangles, {}});
    EXPECT_TRUE(grid.advance(Engine::Deadline::max()));
    return grid;
}

template <typename Query>
auto ask(const Ray& ray, const Triangles& triangles, const auto& name) {
    const MayHit all;
    Query query(ray, triangles, all);
    name(query);
    return query.answer();
}

RayHit byGrid(const Grid& grid, const Ray& ray, const Triangles& triangles, RayTests& tests) {
    return ask<NearestHit>(ray, triangles, [&](NearestHit& q) { grid.visit(ray, q, CountTests{tests}); });
}

RayHit byAll(const Ray& ray, const Triangles& triangles) {
    return ask<NearestHit>(ray, triangles, [&](NearestHit& query) {
        for (std::uint32_t i = 0; i < triangles.size(); ++i)
            query.tryTriangle(i);
    });
}

/// The walk that believes the first hit it finds, though that may lie cells ahead; and tries a triangle in every cell.
RayHit byFirstCell(const Grid& grid, const Ray& ray, const Triangles& triangles, long& tests) {
    return ask<NearestHit>(ray, triangles, [&](NearestHit& query) {
        for (auto walk = grid.begin(query.sheared, query.farthest()); walk;) {
            for (const std::uint32_t primitive : grid.trianglesIn(walk->cell)) {
                ++tests;
                query.tryTriangle(primitive);
            }
            if (query.answer() || !grid.next(*walk)) return;
        }
    });
}
/// The whole walk, but without mailboxes.
long testsWithoutMailboxes(const Grid& grid, const Ray& ray, const Triangles& triangles) {
    long tests = 0;
    ask<NearestHit>(ray, triangles, [&](NearestHit& query) {
        for (auto walk = grid.begin(query.sheared, query.farthest()); walk;) {
            for (const std::uint32_t primitive : grid.trianglesIn(walk->cell)) {
                ++tests;
                query.tryTriangle(primitive);
            }
            if (query.farthest() < walk->leave[walk->nextAxis()] || !grid.next(*walk)) return;
        }
    });
    return tests;
}

/// A grid of 16 cells along each axis whose planes are whole numbers, but for the margin: small triangles about the corners
/// and edges of its cells, one in each corner of the whole to hold it in place, and some that span several cells.
Triangles aboutCorners(unsigned seed) {
    Random random(seed);
    Triangles triangles{{{0, 0, 0}, {0, 0, 0}, {0, 0, 0}}, {{16, 16, 16}, {16, 16, 16}, {16, 16, 16}}};
    const auto whole = [&] { return static_cast<double>(random() % 17); };
    const auto within = [](const dvec3& p) { return glm::clamp(p, dvec3(0), dvec3(16)); };
    while (triangles.size() < 1000) {
        const dvec3 corner(whole(), whole(), whole());
        const double size = triangles.size() % 10 ? 0.2 : 5;
        Triangle t{within(corner + inCube(random, size)), within(corner + inCube(random, size)),
                   within(corner + inCube(random, size))};
        if (triangles.size() % 4 == 0) t.a = corner;
        triangles.push_back(t);
    }
    return triangles;
}

/// Along diagonals, edges and axes, from corners of cells, from halfway, and from outside.
Ray cornerRay(Random& random) {
    const auto whole = [&] { return static_cast<double>(random() % 17); };
    const auto sign = [&] { return static_cast<double>(random() % 3) - 1; };
    Ray ray{{whole(), whole(), whole()}, {sign(), sign(), sign()}};
    if (random() % 8 == 0) ray = {{0, 0, 0}, {1, 1, 1}};
    if (random() % 4 == 0) ray.originCentred -= 20.0 * ray.directionCentred;
    if (random() % 5 == 0) ray.directionCentred += dvec3(0, 0.5, 0);
    if (random() % 5 == 0) ray.originCentred.x += 0.5;
    return ray;
}

TEST(GridTest, CornersOfCellsAreNoHoles) {
    const Triangles triangles = aboutCorners(1);
    const Grid grid = gridOf(triangles);
    EXPECT_EQ(grid.counts(), ivec3(16));
    std::atomic<long> rays = 0, hits = 0, differences = 0, byFirst = 0;
    constexpr long kPerPiece = 1000;
    parallelFor(static_cast<std::size_t>(100 * longRun(10)), [&](std::size_t piece) {
        Random random(piece);
        for (long i = 0; i < kPerPiece; ++i) {
            const Ray ray = cornerRay(random);
            if (!isUsable(ray)) continue;
            RayTests tests;
            long firstTests = 0;
            const RayHit expected = byAll(ray, triangles), found = byGrid(grid, ray, triangles, tests);
            const RayHit first = byFirstCell(grid, ray, triangles, firstTests);
            ++rays;
            hits += bool(expected);
            differences += found.primitive != expected.primitive || found.t != expected.t;
            byFirst += first.primitive != expected.primitive;
        }
    });
    std::cout << rays << " rays, " << hits << " hits, " << differences << " differ; by the first cell with a hit "
              << byFirst << "\n";
    EXPECT_GT(rays, 90'000);
    EXPECT_GT(hits, rays / 5);
    EXPECT_EQ(differences, 0);
    EXPECT_GT(byFirst, 100); // without a look at where the cell ends the answer is wrong
}

// The ray along the diagonal goes from corner to corner: three planes at once, x before y before z.
TEST(GridTest, TheDiagonalIsWalkedInAFixedOrder) {
    Triangles triangles = aboutCorners(2);
    const Grid grid = gridOf(triangles);
    // The grid is a margin larger than the scene, evenly: its diagonal is that of the scene.
    const Ray ray{{-1, -1, -1}, {1, 1, 1}};
    const ShearedRay sheared(ray);
    auto walk = grid.begin(sheared, sheared.farthest);
    ASSERT_TRUE(walk);
    std::vector<ivec3> cells{walk->cell};
    while (grid.next(*walk))
        cells.push_back(walk->cell);
    ASSERT_EQ(cells.size(), 46u); // 15 steps along each axis
    for (std::size_t i = 0; i < cells.size(); ++i) {
        const int n = static_cast<int>(i);
        EXPECT_EQ(cells[i], ivec3((n + 2) / 3, (n + 1) / 3, n / 3));
    }
}

// Large triangles lie in many cells: remembered, each is tried once.
TEST(GridTest, MailboxesSpareTests) {
    Triangles triangles = soup(40, 0.2, 4, 3);
    for (const Triangle& t : soup(2000, 2, 0.05, 4))
        triangles.push_back(t);
    const Grid grid = gridOf(triangles);
    Random random(5);
    RayTests tests;
    long without = 0, rays = 0;
    for (int i = 0; i < 2000; ++i) {
        const Ray ray{inCube(random, 2), inCube(random, 1)};
        const RayHit found = byGrid(grid, ray, triangles, tests);
        EXPECT_EQ(found.primitive, byAll(ray, triangles).primitive);
        without += testsWithoutMailboxes(grid, ray, triangles);
        ++rays;
    }
    std::cout << double(tests.triangles) / rays << " triangles tried per ray, " << double(without) / rays
              << " without mailboxes\n";
    EXPECT_GT(without, 2 * static_cast<long>(tests.triangles));
}

TEST(GridTest, ListsStayShortWhateverTheTriangles) {
    Triangles spread(20'000, Triangle{{-1, -1, 0}, {1, -1, 0}, {0, 1, 1}}); // each through all cells
    const Grid grid = gridOf(spread);
    EXPECT_LE(grid.entries(), 16 * spread.size());
    EXPECT_GE(grid.entries(), spread.size());
    const Grid fine = gridOf(soup(20'000, 1, 0.01, 6));
    EXPECT_GE(fine.counts().x * fine.counts().y * fine.counts().z, 4 * 20'000);
}

} // namespace
} // namespace shadowlab::trace
