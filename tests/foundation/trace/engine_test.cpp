// Two engines that share no code must give one answer, except where float cannot tell: near edges of triangles.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "techniques/foundation/trace/structures/engine.h"
#include "tests/foundation/trace/ray_meshes.h"

namespace shadowlab::trace {
namespace {

using namespace shadowlab::testing;

class EngineTest : public ::testing::Test {
protected:
    void SetUp() override {
        if (!makeEmbreeEngine({})) GTEST_SKIP() << "built without Embree";
    }
    static std::unique_ptr<Engine> built(std::unique_ptr<Engine> engine) {
        engine->advance(Engine::Deadline::max());
        return engine;
    }
};

/// Within a few float roundings of an edge, or of edge-on: either answer is right. `slack` is a share of the triangle.
bool atEdge(const RayHit& hit, double slack) {
    const dvec3& w = hit.barycentric;
    return hit && std::min({w.x, w.y, w.z}) < slack;
}

/// Does the ray run nearly along the triangle? Then rounding moves the hit a hundred times as far, or off it.
bool atSlant(const RayHit& hit, const Triangles& triangles, const Ray& ray) {
    if (!hit) return false;
    const Triangle& t = triangles[hit.primitive];
    const dvec3 normal = glm::cross(t.b - t.a, t.c - t.a);
    return std::abs(glm::dot(normal, ray.directionCentred)) <
           0.01 * glm::length(normal) * glm::length(ray.directionCentred);
}

TEST_F(EngineTest, AgreeOutsideTies) {
    const std::pair<const char*, Triangles> meshes[] = {
        {"soup", soup(2000, 1, 0.3, 7)}, {"sphere", sphere(4)}, {"torus", torus(1, 0.4, 60, 30)}, {"fans", fans(8)}};
    for (const auto& [name, triangles] : meshes) {
        const auto ours = built(makeBvhEngine(EngineInput{triangles, {}})), embree = built(makeEmbreeEngine(triangles));
        const auto isBlocked = [](const Engine& engine, const Ray& ray, std::uint32_t except) {
            return engine.any(ray, {.except = except}) != kNoPrimitive;
        };
        Random random(9);
        const int rays = 50'000 * longRun(20);
        int hits = 0, ties = 0, differences = 0, blocked = 0;
        for (int i = 0; i < rays; ++i) {
            Ray ray;
            ray.originCentred = dvec3(vec3(inCube(random, 2))); // floats, so that both get the same ray
            ray.directionCentred = dvec3(vec3(inCube(random, 1.2) - ray.originCentred));
            const RayHit a = ours->closest(ray), b = embree->closest(ray);
            hits += bool(a);
            // Coordinates of size 2 are 1e-7 apart in float; a slant of one in a hundred makes a few times 1e-5 of
            // that. Two surfaces in one place are a tie, too.
            const bool equallyFar = a && b && std::abs(a.t - b.t) * glm::length(ray.directionCentred) <= 5e-5;
            const bool same = a.primitive == b.primitive && (!a || equallyFar);
            const bool tie = atEdge(a, 1e-4) || atEdge(b, 1e-4) || equallyFar || atSlant(a, triangles, ray) ||
                             atSlant(b, triangles, ray);
            ties += !same && tie;
            differences += !same && !tie;
            if (!a || !b || !same || atEdge(a, 1e-3) || atSlant(a, triangles, ray)) continue;
            // From the hit back to the origin, without the triangle itself: nothing, since it was the nearest.
            Ray back{ray.originCentred + a.t * ray.directionCentred, -ray.directionCentred, 1e-5, 0.999 * a.t};
            const bool ourAnswer = isBlocked(*ours, back, a.primitive);
            const bool theirs = isBlocked(*embree, back, a.primitive);
            differences += ourAnswer != theirs;
            // Onward: behind it there may be more.
            const Ray onward{back.originCentred, ray.directionCentred, 1e-5, 10};
            const bool more = isBlocked(*ours, onward, a.primitive);
            blocked += more;
            if (more != isBlocked(*embree, onward, a.primitive)) {
                Ray next = onward;
                const RayHit ourNext = ours->closest(next), theirNext = embree->closest(next);
                const bool tieNext = atEdge(ourNext, 1e-3) || atEdge(theirNext, 1e-3) ||
                                     atSlant(ourNext, triangles, ray) || atSlant(theirNext, triangles, ray);
                differences += !tieNext;
                ties += tieNext;
            }
        }
        std::cout << name << ": " << rays << " rays, " << hits << " hits, " << blocked << " blocked, " << ties
                  << " ties, " << differences << " differences\n";
        EXPECT_EQ(differences, 0) << name;
        EXPECT_LT(ties, rays / 10) << name; // of the fans' triangles, every fifth is there twice
        EXPECT_GT(hits, rays / 20) << name;
        EXPECT_GT(blocked, rays / 100) << name;
    }
}

TEST_F(EngineTest, WhatMayNotBlockDoesNot) {
    const Triangles two = {{{-1, -1, 0}, {1, -1, 0}, {0, 1, 0}}, {{-1, -1, 1}, {1, -1, 1}, {0, 1, 1}}};
    const Ray ray{{0, 0, -1}, {0, 0, 1}, 0, 10};
    for (const auto& engine : {built(makeBvhEngine(EngineInput{two, {}})), built(makeEmbreeEngine(two)),
                               built(makeEmbreeEngine(two, true))}) {
        const std::vector<std::uint8_t> both{1, 1}, first{1, 0}, none{0, 0};
        EXPECT_NE(engine->any(ray, {.except = kNoPrimitive, .flags = both.data()}), kNoPrimitive);
        EXPECT_NE(engine->any(ray, {.except = 0, .flags = both.data()}), kNoPrimitive);
        EXPECT_EQ(engine->any(ray, {.except = 0, .flags = first.data()}), kNoPrimitive);
        EXPECT_EQ(engine->any(ray, {.except = kNoPrimitive, .flags = none.data()}), kNoPrimitive);
        EXPECT_EQ(engine->closest(ray).primitive, 0u);
        EXPECT_EQ(engine->closest(ray, {.except = 0}).primitive, 1u);
        EXPECT_FALSE(engine->closest(ray, {.except = 0, .flags = first.data()}));
        EXPECT_FALSE(engine->closest(Ray{{0, 0, std::nan("")}, {0, 0, 1}}));
    }
}

} // namespace
} // namespace shadowlab::trace
