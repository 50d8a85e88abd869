// Rays that meet a plane at smaller and smaller angles, from a hundred metres away.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "techniques/foundation/trace/ray_triangle.h"
#include "tests/foundation/trace/ray_meshes.h"

namespace shadowlab::trace {
namespace {

using testing::inCube;
using testing::number;
using testing::Random;
using Long3 = glm::vec<3, long double>;

constexpr double kDistance = 100;   ///< metres from the ray's origin to the point it is aimed at
constexpr int kRaysPerAngle = 2000; ///< at seven angles

/// A triangle, a ray at a point within it, and a ray from the same place that rises as much as the other one falls.
struct Grazing {
    Triangle triangle;
    Ray toward, away;
};

Grazing grazing(Random& random, double angle) {
    const dvec3 normal = testing::onSphere(random);
    const dvec3 along = glm::normalize(glm::cross(normal, testing::onSphere(random)));
    const dvec3 across = glm::cross(normal, along), middle = inCube(random, 1);
    // Long enough that what rounding moves a flat ray by, a hundred metres times 1e-16 / 1e-7, stays within it.
    const Triangle triangle{middle - 60.0 * along - 5.0 * across, middle + 60.0 * along - 5.0 * across,
                            middle + 10.0 * across};
    const dvec3 target = middle + number(random, -10, 10) * along;
    const dvec3 flat = kDistance * along;
    const dvec3 rise = kDistance * std::tan(angle) * normal;
    const dvec3 origin = target - flat + rise;
    return {triangle, Ray{origin, target - origin}, Ray{origin, flat + rise}};
}

/// Where the ray meets the triangle's plane, in units of its direction, and by how many times rounding is made larger there.
struct Plane {
    long double t, condition;
};
Plane planeOf(const Ray& ray, const Triangle& triangle) {
    const Long3 a(triangle.a), o(ray.originCentred), d(ray.directionCentred);
    const Long3 n = glm::cross(Long3(triangle.b) - a, Long3(triangle.c) - a);
    const long double down = glm::dot(n, d);
    return {glm::dot(n, a - o) / down, glm::length(n) * glm::length(d) / std::abs(down)};
}

// How far the numbers that are given may be from the point they were made for, as shares of the way: a rounding of each
// coordinate, magnified by how flat the ray is. Four units in the last place are what the arithmetic itself may add.
constexpr double kRoundings = 4;

TEST(GrazingRays, HitWhereTheyHaveTo) {
    Random random(17);
    int hits = 0, compared = 0;
    for (double angle = 1e-1; angle > 0.5e-7; angle /= 10) {
        double worst = 0;
        for (int i = 0; i < kRaysPerAngle; ++i) {
            const Grazing g = grazing(random, angle);
            const ShearedRay toward(g.toward), away(g.away);
            const auto hit = intersect(toward, g.triangle, toward.farthest);
            ASSERT_TRUE(hit) << angle;
            ASSERT_FALSE(intersect(away, g.triangle, away.farthest)) << angle;
            const Plane exact = planeOf(g.toward, g.triangle);
            const long double t = static_cast<long double>(hit->reach) / toward.reachPerT;
            worst = std::max(worst, static_cast<double>(std::abs(t / exact.t - 1) / exact.condition) / 0x1p-52);
            ++hits;
        }
        std::cout << angle << " rad: off by " << worst << " units in the last place, times the condition\n";
        EXPECT_LE(worst, kRoundings) << angle;
        ++compared;
    }
    EXPECT_EQ(compared, 7);
    EXPECT_EQ(hits, 7 * kRaysPerAngle);
}

/// The schoolbook's distance along the ray to a plane, with 24 bits.
float planeDistanceInFloat(const Ray& ray, const Triangle& triangle) {
    const vec3 a(triangle.a), o(ray.originCentred), d(ray.directionCentred);
    const vec3 n = glm::cross(vec3(triangle.b) - a, vec3(triangle.c) - a);
    return glm::dot(n, a - o) / glm::dot(n, d);
}

TEST(GrazingRays, InFloatThePlaneIsLost) {
    Random random(17);
    int lost = 0;
    for (int i = 0; i < kRaysPerAngle; ++i) {
        const Grazing g = grazing(random, 1e-7);
        const float t = planeDistanceInFloat(g.toward, g.triangle);
        // A hundredth of the way is a metre beside the place; behind the origin there is none at all.
        lost += !(std::abs(t - 1) <= 0.01f);
    }
    EXPECT_GT(lost, kRaysPerAngle / 4);
}

} // namespace
} // namespace shadowlab::trace
