// The lecture's secondary rays and the rays' intersections, against what a formula or a plain search says.
// SPDX-License-Identifier: MIT
#include <cmath>
#include <random>

#include "techniques/foundation/scene/model/shapes.h"
#include "techniques/lecture/lecture.h"
#include "tests/support/scenes.h"

namespace shadowlab {
namespace {

dvec3 randomDirection(std::mt19937& random) {
    std::normal_distribution<double> normal;
    return glm::normalize(dvec3(normal(random), normal(random), normal(random)));
}

// R = 2 (N.V) N - V with V = -u: as steep as u, on the same side, in one plane with u and N.
TEST(LectureRays, AReflectedRayLeavesAsItCame) {
    std::mt19937 random(1);
    int compared = 0;
    for (int i = 0; i < 1000; ++i) {
        const dvec3 u = randomDirection(random), side = randomDirection(random);
        const dvec3 N = glm::dot(u, side) < 0 ? side : -side;
        const dvec3 R = lecture::reflected(u, N);
        // A dozen roundings of numbers up to 2.
        EXPECT_NEAR(glm::length(R), 1, 1e-14);
        EXPECT_NEAR(glm::dot(R, N), -glm::dot(u, N), 1e-14);
        EXPECT_NEAR(glm::dot(R, glm::cross(u, N)), 0, 1e-14);
        ++compared;
    }
    EXPECT_EQ(compared, 1000);
}

TEST(LectureRays, ARefractedRayObeysSnellOrIsTotallyReflected) {
    std::mt19937 random(2);
    int refracted = 0, total = 0;
    for (int i = 0; i < 2000; ++i) {
        const dvec3 u = randomDirection(random), side = randomDirection(random);
        const dvec3 N = glm::dot(u, side) < 0 ? side : -side;
        const double eta = i % 2 ? 1.5 : 1 / 1.5, sinIncoming = glm::length(glm::cross(u, N));
        const auto T = lecture::refracted(u, N, eta);
        EXPECT_EQ(T.has_value(), eta * sinIncoming < 1) << "beyond the critical angle there is no refraction ray";
        if (!T) {
            ++total;
            continue;
        }
        ++refracted;
        // Near the critical angle a root turns a rounding of 1e-16 into 1e-8 of the cosine, but not of the sine.
        EXPECT_NEAR(glm::length(glm::cross(*T, N)), eta * sinIncoming, 1e-12);
        EXPECT_NEAR(glm::length(*T), 1, 1e-12);
        EXPECT_LT(glm::dot(*T, N), 0) << "on the other side";
        EXPECT_NEAR(glm::dot(*T, glm::cross(u, N)), 0, 1e-12);
    }
    EXPECT_GT(refracted, 1000);
    EXPECT_GT(total, 200);
    EXPECT_EQ(lecture::refracted({0, -1, 0}, {0, 1, 0}, 1.5), dvec3(0, -1, 0)) << "straight on";
}

/// The nearest triangle that the ray meets, by the plane of each and its three edges: another way than the lecture's.
std::optional<double> nearestByPlanes(const lecture::RayScene& rays, const lecture::Ray& ray) {
    std::optional<double> nearest;
    for (const lecture::Triangle& t : rays.triangles()) {
        const dvec3 normal = glm::cross(t.bWorld - t.aWorld, t.cWorld - t.aWorld);
        const double distance = glm::dot(normal, t.aWorld - ray.startWorld) / glm::dot(normal, ray.u);
        const dvec3 place = ray.startWorld + distance * ray.u;
        bool inside = distance > ray.nearest;
        for (const auto& [from, to] : {std::pair(t.aWorld, t.bWorld), {t.bWorld, t.cWorld}, {t.cWorld, t.aWorld}})
            inside = inside && glm::dot(glm::cross(to - from, place - from), normal) >= 0;
        if (inside && (!nearest || distance < *nearest)) nearest = distance;
    }
    return nearest;
}

// Bounding volumes save intersections, and change none.
TEST(LectureRays, TheTreeOfVolumesFindsWhatTryingEveryTriangleFinds) {
    const lecture::RayScene rays(testing::snapshot(testing::simpleScene()));
    ASSERT_GT(rays.triangles().size(), 1000u);
    std::mt19937 random(3);
    int met = 0, missed = 0;
    for (int i = 0; i < 3000; ++i) {
        const dvec3 from = 4.0 * randomDirection(random) + dvec3(0, 1, 0);
        const lecture::Ray ray{from, glm::normalize(dvec3(0, 0.8, 0) + 1.5 * randomDirection(random) - from)};
        const auto surface = rays.firstSurface(ray);
        const auto expected = nearestByPlanes(rays, ray);
        ASSERT_EQ(surface.has_value(), expected.has_value()) << i;
        (expected ? met : missed) += 1;
        if (!expected) continue;
        EXPECT_NEAR(surface->distance, *expected,
                    1e-9); // seen at a grazing angle rounding grows a thousandfold and more
        EXPECT_LE(glm::dot(surface->N, ray.u), 0);
        EXPECT_TRUE(rays.isBlocked(ray));
        EXPECT_FALSE(rays.isBlocked({ray.startWorld, ray.u, lecture::kContact, *expected - 1e-6})) << "before it";
    }
    EXPECT_GT(met, 1500);
    EXPECT_GT(missed, 200);
}

} // namespace
} // namespace shadowlab
