// The tree against trying every triangle: same primitive, same distance, whatever the mesh. And trees of meshes that
// cannot be cut well.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <atomic>
#include <cstdlib>
#include <cstring>

#include "techniques/foundation/trace/bvh/bvh_build.h"
#include "techniques/foundation/trace/bvh/bvh_traverse.h"
#include "techniques/foundation/trace/parallel.h"
#include "tests/foundation/trace/ray_meshes.h"

namespace shadowlab::trace {
namespace {

using namespace shadowlab::testing;

/// From anywhere to anywhere; every third at a vertex, every third along an axis.
Ray randomRay(Random& random, const Triangles& triangles, int number_) {
    Ray ray;
    const Triangle& from = triangles[random() % triangles.size()];
    const Triangle& to = triangles[random() % triangles.size()];
    ray.originCentred = from.a + inCube(random, 2);
    ray.directionCentred = (to.b - ray.originCentred) * number(random, 0.1, 3);
    if (number_ % 3 == 1) ray.directionCentred += inCube(random, 1);
    if (number_ % 12 == 2) aimAlongAxis(ray, to.b, static_cast<int>(random() % 3), number_ % 24 == 2);
    limitSome(ray, random, number_);
    return ray;
}

struct Counts {
    std::atomic<long> rays = 0, hits = 0, differences = 0;
};

void compare(const Triangles& triangles, long rays, unsigned seed, Counts& counts) {
    const Bvh bvh = buildBvh(triangles);
    EXPECT_LE(bvh.depth, Bvh::kMostDepth);
    constexpr long kPerPiece = 5000;
    parallelFor(static_cast<std::size_t>(rays / kPerPiece), [&](std::size_t piece) {
        Random random(seed * 1000 + piece);
        for (int i = 0; i < kPerPiece; ++i) {
            const Ray ray = randomRay(random, triangles, i);
            const RayHit expected = closestOfAll(triangles, ray), found = bvh.closest(ray);
            const bool any = bvh.any(ray, [](std::uint32_t) { return true; }) != kNoPrimitive;
            const bool same = found.primitive == expected.primitive && found.t == expected.t &&
                              found.barycentric == expected.barycentric && any == bool(expected);
            counts.differences += !same;
            counts.hits += bool(expected);
            ++counts.rays;
        }
    });
}

TEST(BvhTest, EqualsTryingEveryTriangle) {
    const std::pair<const char*, Triangles> meshes[] = {
        {"soup", soup(300, 1, 0.5, 1)},   {"sphere", sphere(3)},
        {"torus", torus(1, 0.4, 20, 10)}, {"fans", fans(2)},
        {"far details", farDetails(3)},   {"degenerate", degenerate(4)}};
    long all = 0;
    unsigned seed = 0;
    for (const auto& [name, triangles] : meshes) {
        Counts counts;
        compare(triangles, 170'000L * longRun(20), ++seed, counts);
        std::cout << name << ": " << triangles.size() << " triangles, " << counts.rays << " rays, " << counts.hits
                  << " hits, " << counts.differences << " differences\n";
        EXPECT_EQ(counts.differences, 0) << name;
        EXPECT_GT(counts.hits, counts.rays / 20) << name;
        EXPECT_LT(counts.hits, counts.rays) << name;
        all += counts.rays;
    }
    EXPECT_GE(all, 1'000'000);
}

TEST(BvhTest, OfEquallyNearTrianglesTheFirstIsHit) {
    const Bvh bvh = buildBvh(Triangles(1000, Triangle{{-1, -1, 0}, {1, -1, 0}, {0, 1, 0}}));
    const Ray ray{{0, 0, 1}, {0, 0, -1}};
    EXPECT_EQ(bvh.closest(ray).primitive, 0u);
    EXPECT_EQ(bvh.closest(ray, [](std::uint32_t p) { return p >= 700; }).primitive, 700u);
    EXPECT_EQ(bvh.closest(ray).t, 1.0);
}

TEST(BvhTest, TheEndsOfTheRayAreNotPartOfIt) {
    const Bvh bvh = buildBvh({Triangle{{-1, -1, 0}, {1, -1, 0}, {0, 1, 0}}});
    const auto hit = [&](double nearest, double farthest) {
        return bool(bvh.closest(Ray{{0, 0, 1}, {0, 0, -1}, nearest, farthest}));
    };
    EXPECT_TRUE(hit(0.5, 1.5));
    EXPECT_FALSE(hit(1, 1.5));
    EXPECT_FALSE(hit(0.5, 1));
    EXPECT_TRUE(hit(std::nextafter(1.0, 0.0), std::nextafter(1.0, 2.0)));
}

TEST(BvhTest, HardMeshesMakeNoDeepTrees) {
    Triangles oneHuge = soup(100'000, 1e-3, 1e-5, 5);
    oneHuge.push_back({{-1e6, 0, -1e6}, {1e6, 0, -1e6}, {0, 0, 1e6}});
    Triangles collinear, doubling;
    for (int i = 0; i < 100'000; ++i)
        collinear.push_back({{i * 1e-3, 0, 0}, {i * 1e-3, 1, 0}, {i * 1e-3, 0, 1}});
    for (int i = 0; i < 20'000; ++i) { // each twice as far as the last: cuts by area peel off one at a time
        const double x = std::ldexp(1.0, i % 100);
        doubling.push_back({{x, 0, 0}, {x, x, 0}, {x, 0, x}});
    }
    const std::pair<const char*, Triangles> meshes[] = {
        {"identical", Triangles(100'000, Triangle{{-1, -1, 0}, {1, -1, 0}, {0, 1, 0}})},
        {"one huge, many tiny", oneHuge},
        {"collinear", collinear},
        {"doubling", doubling}};
    for (const auto& [name, triangles] : meshes) {
        const Bvh bvh = buildBvh(triangles);
        std::cout << name << ": " << triangles.size() << " triangles, depth " << bvh.depth << "\n";
        EXPECT_LE(bvh.depth, Bvh::kMostDepth) << name;
        Random random(6);
        int hits = 0;
        for (int i = 0; i < 200; ++i) {
            const Ray ray = randomRay(random, triangles, i);
            const RayHit expected = closestOfAll(triangles, ray), found = bvh.closest(ray);
            EXPECT_EQ(found.primitive, expected.primitive) << name;
            EXPECT_EQ(found.t, expected.t) << name;
            hits += bool(expected);
        }
        EXPECT_GT(hits, 20) << name;
    }
}

TEST(BvhTest, NothingAndNonsenseAreNotHit) {
    const double nan = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();
    const Ray ray{{0, 0, 1}, {0, 0, -1}};
    EXPECT_FALSE(buildBvh({}).closest(ray));
    Triangles triangles(10, Triangle{{nan, 0, 0}, {1, 0, 0}, {0, 1, 0}});
    triangles.push_back({{-1, -1, 0}, {inf, -1, 0}, {0, 1, 0}});
    EXPECT_FALSE(buildBvh(triangles).closest(ray));
    triangles.push_back({{-1, -1, 0}, {1, -1, 0}, {0, 1, 0}});
    const Bvh bvh = buildBvh(triangles);
    EXPECT_EQ(bvh.closest(ray).primitive, 11u);

    const auto anything = [](std::uint32_t) { return true; };
    for (const double bad : {nan, inf, -inf})
        for (int axis = 0; axis < 3; ++axis) {
            Ray origin = ray, direction = ray;
            origin.originCentred[axis] = bad;
            direction.directionCentred[axis] = bad;
            for (const Ray& one : {origin, direction}) {
                EXPECT_FALSE(bvh.closest(one));
                EXPECT_EQ(bvh.any(one, anything), kNoPrimitive);
            }
        }
    for (const Ray& one : {Ray{{0, 0, 1}, dvec3(0)}, Ray{{0, 0, 1}, dvec3(-0.0)}, Ray{{0, 0, 1}, {0, 0, -1}, nan, 2},
                           Ray{{0, 0, 1}, {0, 0, -1}, 0, nan}, Ray{{0, 0, 1}, {0, 0, -1}, 2, 1}})
        EXPECT_FALSE(bvh.closest(one));
    // Very long and very short directions are still directions.
    for (const double length : {1e-200, 1e-30, 1e30, 1e200})
        EXPECT_EQ(bvh.closest(Ray{{0, 0, 1}, {0, 0, -length}}).primitive, 11u) << length;
}

// The kernels differ in how many lanes an instruction has, and in nothing else: what is tried is the same, too.
TEST(BvhTest, TheSameWithEveryKernel) {
    const BvhKernels* const avx2 = avx2BvhKernels();
    if (!avx2) GTEST_SKIP() << "this processor has no AVX2";
    Bvh bvh = buildBvh(soup(3000, 1, 0.2, 7));
    Random random(8);
    int hits = 0, differences = 0;
    constexpr int kRays = 20'000;
    for (int i = 0; i < kRays; ++i) {
        const Ray ray = randomRay(random, bvh.triangles, i);
        RayHit found[2];
        RayTests tests[2];
        std::uint32_t any[2];
        for (const int k : {0, 1}) {
            bvh.kernels = k ? avx2 : &kGenericBvhKernels;
            const auto anything = [](std::uint32_t) { return true; };
            found[k] = bvh.closest(ray, anything, NoHoles{}, CountTests{tests[k]});
            any[k] = bvh.any(ray, anything, NoHoles{}, CountTests{tests[k]});
        }
        hits += bool(found[0]);
        differences += found[0].primitive != found[1].primitive || found[0].t != found[1].t || any[0] != any[1] ||
                       tests[0].volumes != tests[1].volumes || tests[0].triangles != tests[1].triangles;
    }
    EXPECT_EQ(differences, 0);
    EXPECT_GT(hits, kRays / 4);
}

TEST(BvhTest, TheSameTreeForAnyNumberOfThreads) {
    const Triangles triangles = soup(30'000, 1, 0.02, 9);
    std::vector<Bvh> trees;
    const char* const before = std::getenv("SHADOWLAB_THREADS");
    const std::string kept = before ? before : "";
    for (const char* threads : {"1", "2", "5"}) {
        ::setenv("SHADOWLAB_THREADS", threads, 1);
        trees.push_back(buildBvh(triangles));
    }
    before ? ::setenv("SHADOWLAB_THREADS", kept.c_str(), 1) : ::unsetenv("SHADOWLAB_THREADS");
    ASSERT_GT(trees[0].nodes.size(), 1000u);
    for (const Bvh& tree : trees) {
        ASSERT_EQ(tree.nodes.size(), trees[0].nodes.size());
        ASSERT_EQ(tree.leaves.size(), trees[0].leaves.size());
        for (std::size_t i = 0; i < tree.nodes.size(); ++i) {
            EXPECT_TRUE(std::ranges::equal(tree.nodes[i].children, trees[0].nodes[i].children));
            EXPECT_EQ(std::memcmp(tree.nodes[i].planes, trees[0].nodes[i].planes, sizeof(BvhNode::planes)), 0);
        }
        for (std::size_t i = 0; i < tree.leaves.size(); ++i)
            EXPECT_TRUE(std::ranges::equal(tree.leaves[i].primitives, trees[0].leaves[i].primitives));
    }
}

TEST(BvhTest, BuiltInSlicesItIsTheSameTree) {
    const Triangles triangles = torus(1, 0.4, 64, 32);
    const Bvh whole = buildBvh(triangles);
    BvhBuilder builder(triangles);
    int slices = 1;
    while (!builder.advance(std::chrono::steady_clock::time_point::min()))
        ++slices;
    EXPECT_GT(slices, 5);
    EXPECT_EQ(builder.done(), 1.0);
    const Bvh sliced = builder.take();
    ASSERT_EQ(sliced.nodes.size(), whole.nodes.size());
    for (std::size_t i = 0; i < whole.leaves.size(); ++i)
        for (int k = 0; k < 4; ++k)
            EXPECT_EQ(sliced.leaves[i].primitives[k], whole.leaves[i].primitives[k]);
}

} // namespace
} // namespace shadowlab::trace
