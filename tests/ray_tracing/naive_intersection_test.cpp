// The naive ray-triangle test loses rays at edges that two triangles share; the watertight one loses none of the same rays.
// SPDX-License-Identifier: MIT
#include "techniques/ray_tracing/structures/naive_intersection.h"

#include <gtest/gtest.h>

#include <chrono>
#include <iostream>

#include "techniques/foundation/trace/bvh/bvh_build.h"
#include "techniques/foundation/trace/bvh/bvh_traverse.h"
#include "tests/foundation/trace/ray_meshes.h"

namespace shadowlab::ray_tracing {
namespace {

using namespace shadowlab::testing;

constexpr int kRays = 40'000;

/// Of rays from inside a closed ball at points on its edges: how many does nothing stop?
int lost(const trace::Engine& engine, const Triangles& triangles) {
    Random random(7);
    int lost = 0;
    for (int i = 0; i < kRays; ++i) {
        trace::Ray ray;
        ray.originCentred = inCube(random, 0.4);
        const trace::Triangle& t = triangles[random() % triangles.size()];
        ray.directionCentred = glm::mix(t.a, t.b, number(random, 0, 1)) - ray.originCentred;
        const bool isHit = static_cast<bool>(engine.closest(ray));
        EXPECT_EQ(isHit, engine.any(ray) != trace::kNoPrimitive);
        lost += isHit ? 0 : 1;
    }
    return lost;
}

TEST(NaiveIntersection, LosesRaysAtSharedEdgesWhereTheOtherLosesNone) {
    const Triangles triangles = sphere(4);
    trace::BvhBuilder builder(triangles);
    builder.advance(std::chrono::steady_clock::time_point::max());
    const trace::Bvh bvh = builder.take();
    const int watertight = lost(*trace::makeBvhEngine(bvh), triangles);
    const int byRounding = lost(*makeNaiveEngine(bvh, 0.0f), triangles);
    const int byMargin = lost(*makeNaiveEngine(bvh, 1e-3f), triangles);
    std::cout << "of " << kRays << " rays at edges: watertight loses " << watertight << ", naive " << byRounding
              << ", with a margin of a thousandth " << byMargin << "\n";
    EXPECT_EQ(watertight, 0);
    EXPECT_GT(byRounding,
              kRays / 100);     // of each edge both triangles round on their own: some one in ten is refused twice
    EXPECT_EQ(byMargin, kRays); // all of them pass nearer to one
}

TEST(NaiveIntersection, MarginIsAShareOfTheHeight) {
    const trace::Triangle triangle{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    const auto hits = [&](double x, double y, float margin) {
        trace::Ray ray;
        ray.originCentred = {x, y, 1};
        return naiveHit(ray, triangle, margin).has_value();
    };
    EXPECT_TRUE(hits(0.25, 0.25, 0.2f));
    EXPECT_FALSE(hits(0.15, 0.25, 0.2f));
    EXPECT_FALSE(hits(0.25, 0.15, 0.2f));
    EXPECT_FALSE(hits(0.45, 0.45, 0.2f));
    EXPECT_TRUE(hits(0.45, 0.45, 0.05f));
    EXPECT_FALSE(hits(0.25, 0.0, 0.0f)) << "on the edge itself: refused, and by its neighbour as well";
    EXPECT_FALSE(hits(-0.1, 0.5, 0.0f));
}

} // namespace
} // namespace shadowlab::ray_tracing
