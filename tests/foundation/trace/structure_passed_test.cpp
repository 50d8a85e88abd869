// The parts of a structure that a ray passes, compared with a test of each box and ball by itself.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "techniques/foundation/trace/structures/engine.h"

namespace shadowlab::trace {
namespace {

constexpr std::size_t kAll = 1 << 20;

/// Eight objects of fifty triangles, each in a corner of a cube: a ray misses most of them.
std::vector<Triangle> someTriangles() {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> place(-0.35, 0.35), size(-0.1, 0.1);
    const auto point = [&](auto& from) { return dvec3(from(random), from(random), from(random)); };
    std::vector<Triangle> triangles;
    for (int i = 0; i < 400; ++i) {
        const int object = i / 50;
        const dvec3 corner((object & 1) ? 0.6 : -0.6, (object & 2) ? 0.6 : -0.6, (object & 4) ? 0.6 : -0.6);
        const dvec3 at = corner + point(place);
        triangles.push_back({at + point(size), at + point(size), at + point(size)});
    }
    return triangles;
}

/// Does the segment from `from` to `to` touch the part, grown by `margin`? The distance to it is convex along the segment:
/// its least is found by thirds.
bool touches(const dvec3& from, const dvec3& to, const StructurePart& part, double margin) {
    const dvec3 lower = part.lowerCentred - margin, upper = part.upperCentred + margin;
    if (!part.isBall && glm::any(glm::greaterThan(lower, upper))) return false;
    const auto distance = [&](double t) {
        const dvec3 p = glm::mix(from, to, t);
        if (part.isBall) return glm::distance(p, part.centreCentred) - part.radius - margin;
        return glm::length(p - glm::clamp(p, lower, upper));
    };
    double low = 0, high = 1;
    for (int i = 0; i < 120; ++i) {
        const double third = (high - low) / 3;
        if (distance(low + third) < distance(high - third))
            high -= third;
        else
            low += third;
    }
    return distance(0.5 * (low + high)) <= 1e-9;
}

/// On how many axes do two cells lie apart?
int stepsBetween(const StructurePart& a, const StructurePart& b) {
    int steps = 0;
    for (int axis = 0; axis < 3; ++axis)
        steps += a.lowerCentred[axis] != b.lowerCentred[axis];
    return steps;
}

class StructurePassed : public ::testing::TestWithParam<Structure> {};

TEST_P(StructurePassed, IsWhatTheRayTouchesBeforeItsEnd) {
    const std::vector<Triangle> triangles = someTriangles();
    const std::vector<std::uint32_t> objects{0, 50, 100, 150, 200, 250, 300, 350};
    const auto engine = makeEngine(GetParam(), {triangles, objects});
    ASSERT_TRUE(engine->advance(Engine::Deadline::max()));
    std::mt19937 random(3);
    std::uniform_real_distribution<double> place(-1.5, 1.5);
    int passed = 0, missed = 0;
    for (int i = 0; i < 200; ++i) {
        const dvec3 from(place(random), place(random), place(random)), to(place(random), place(random), place(random));
        Ray ray;
        ray.originCentred = from;
        ray.directionCentred = 0.5 * (to - from); // of any length: the end is at t = 2
        ray.farthest = 2;
        const std::vector<StructurePart> found = engine->passed(ray, kAll);
        // What lies within a millionth of the ray may count or not: distances found by thirds are no better.
        for (const StructurePart& part : found)
            EXPECT_TRUE(touches(from, to, part, 1e-6));
        passed += static_cast<int>(found.size());
        if (GetParam() == Structure::grid) {
            for (std::size_t c = 1; c < found.size(); ++c)
                EXPECT_EQ(stepsBetween(found[c - 1], found[c]), 1) << "cells come in order, each beside the last";
            continue;
        }
        for (const StructurePart& part : engine->parts(kAll)) {
            const bool isFound = std::ranges::any_of(found, [&](const StructurePart& other) {
                return other.level == part.level && other.lowerCentred == part.lowerCentred &&
                       other.upperCentred == part.upperCentred && other.centreCentred == part.centreCentred &&
                       other.radius == part.radius;
            });
            if (isFound) continue;
            ++missed;
            EXPECT_FALSE(touches(from, to, part, -1e-6));
        }
    }
    EXPECT_GT(passed, 100);
    if (GetParam() != Structure::grid) {
        EXPECT_GT(missed, 100);
    }
}

INSTANTIATE_TEST_SUITE_P(All, StructurePassed,
                         ::testing::Values(Structure::objectSpheres, Structure::objectBoxes, Structure::groups,
                                           Structure::sphereTree, Structure::bvh, Structure::grid));

// A ray along x through a row of cells steps through each of them once.
TEST(GridPassed, WalksEveryCellOfARow) {
    const std::vector<Triangle> triangles = someTriangles();
    const std::vector<std::uint32_t> objects{0};
    const auto grid = makeEngine(Structure::grid, {triangles, objects});
    ASSERT_TRUE(grid->advance(Engine::Deadline::max()));
    Ray ray;
    ray.originCentred = {-3, 0.017, 0.023};
    ray.directionCentred = {1, 0, 0};
    const std::vector<StructurePart> cells = grid->passed(ray, kAll);
    ASSERT_GE(cells.size(), 5u);
    for (std::size_t i = 1; i < cells.size(); ++i)
        EXPECT_NEAR(cells[i].lowerCentred.x, cells[i - 1].upperCentred.x, 1e-12);
    RayTests tests;
    (void)grid->closest(ray, {}, tests);
    EXPECT_LE(tests.steps, cells.size()) << "who looks for a hit stops there";
    EXPECT_EQ(grid->passed(ray, 3).size(), 3u);
}

} // namespace
} // namespace shadowlab::trace
