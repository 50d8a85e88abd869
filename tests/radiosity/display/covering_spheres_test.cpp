// Spheres around meshes: that they cover them, and that directions are chosen as often as their density says.
// SPDX-License-Identifier: MIT
#include "techniques/radiosity/display/covering_spheres.h"

#include <gtest/gtest.h>

#include <cmath>

#include <glm/gtc/constants.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include "techniques/foundation/scene/model/shapes.h"
#include "tests/radiosity/lone_mesh.h"
#include "tests/radiosity/quasirandom.h"

namespace shadowlab::radiosity {
namespace {

using testing::objectOf;

/// 2 m long and 0.1 m thick.
scene::Object longThing() { return objectOf(scene::makeSphere(1, 48), glm::scale(testing::translation({5, 1, 0}), dvec3(0.05, 1, 0.05))); }

// Of a ball all directions meet it, but for the flat sides of its mesh; and 1 / density is the solid angle of its sphere.
TEST(CoveringSpheres, OfABallIsOneThatFits) {
    const CoveringSpheres spheres(objectOf(scene::makeSphere(0.5, 48), testing::translation({1, 2, 3})));
    EXPECT_EQ(spheres.count(), 1u);
    const dvec3 from(1, 2, 5);
    const double solidAngle = glm::two_pi<double>() * (1 - std::sqrt(1 - 0.25 * 0.25));
    for (int i = 0; i < 1000; ++i) {
        const auto x = testing::quasirandom4(i);
        const auto direction = spheres.direction(from, x[0], {x[1], x[2]});
        ASSERT_TRUE(direction);
        EXPECT_NEAR(glm::length(*direction), 1, 1e-12);
        EXPECT_LE(glm::length(glm::cross(*direction, dvec3(0, 0, -2))), 0.5 + 1e-6) << "floats";
        EXPECT_NEAR(spheres.density(from, *direction) * solidAngle, 1, 1e-5) << "floats";
    }
    EXPECT_EQ(spheres.density(from, {0, 0, 1}), 0) << "away from it";
    EXPECT_TRUE(spheres.hold({1, 2, 3.4}));
    EXPECT_FALSE(spheres.direction({1, 2, 3.4}, 0.5, {0.5, 0.5}));
    EXPECT_EQ(spheres.density({1, 2, 3.4}, {0, 0, -1}), 0);
}

TEST(CoveringSpheres, ALongThingHasARowOfThemThatHoldIt) {
    const scene::Object object = longThing();
    const CoveringSpheres spheres(object);
    EXPECT_GE(spheres.count(), 8u);
    const dmat4 worldFromMesh = scene::worldFromMesh(object);
    int points = 0;
    for (const uvec3& corners : object.mesh->triangles)
        for (int i = 0; i < 16; ++i) {
            const auto x = testing::quasirandom4(i);
            const double s = std::sqrt(x[0]);
            const dvec3 weights(1 - s, s * (1 - x[1]), s * x[1]);
            dvec3 point(0);
            for (int k = 0; k < 3; ++k)
                point += weights[k] * dvec3(worldFromMesh * dvec4(object.mesh->positionsMesh[corners[k]], 1));
            points += spheres.hold(point) ? 1 : 0;
        }
    EXPECT_EQ(points, 16 * static_cast<int>(object.mesh->triangles.size()));
}

// The density's integral is 1, and that of 1 over all chosen directions the solid angle in which any is chosen.
TEST(CoveringSpheres, DirectionsAreChosenAsOftenAsTheirDensitySays) {
    const CoveringSpheres spheres(longThing());
    const dvec3 from(5.3, 1.2, 0.6);
    constexpr int kDirections = 400'000;
    double integral = 0, support = 0, chosen = 0;
    for (int i = 0; i < kDirections; ++i) {
        const auto x = testing::quasirandom4(i);
        const double height = 1 - 2 * x[0], across = std::sqrt(1 - height * height), turn = glm::two_pi<double>() * x[1];
        const double density = spheres.density(from, {across * std::cos(turn), across * std::sin(turn), height});
        integral += 4 * glm::pi<double>() * density / kDirections;
        support += density > 0 ? 4 * glm::pi<double>() / kDirections : 0;
        const auto direction = spheres.direction(from, x[2], {x[3], x[0]});
        ASSERT_TRUE(direction);
        ASSERT_GT(spheres.density(from, *direction), 0);
        chosen += 1 / spheres.density(from, *direction) / kDirections;
    }
    EXPECT_NEAR(integral, 1, 0.01) << "a hundredth of all directions, of which each sphere has a part";
    EXPECT_GT(support, 0.1);
    EXPECT_NEAR(chosen, support, 0.01 * support);
}

} // namespace
} // namespace shadowlab::radiosity
