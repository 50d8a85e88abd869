// Rays to meshes: by spheres or by points, and as often as their density says.
// SPDX-License-Identifier: MIT
#include "techniques/radiosity/display/mesh_aim.h"

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

TEST(MeshAim, BallsFillTheirSpheresAndRingsDoNot) {
    EXPECT_TRUE(MeshAim(objectOf(scene::makeSphere(0.5, 48))).usesSpheres());
    EXPECT_TRUE(MeshAim(objectOf(scene::makeSphere(1, 48), glm::scale(dmat4(1), dvec3(0.6, 1, 0.6)))).usesSpheres()) << "an egg";
    EXPECT_FALSE(MeshAim(objectOf(scene::makeSphere(1, 48), glm::scale(dmat4(1), dvec3(0.05, 1, 0.05)))).usesSpheres()) << "a row of them leaves a tube more noise than its points do";
    const MeshAim ring(objectOf(scene::makeTorus(0.5, 0.03, {64, 32})));
    EXPECT_FALSE(ring.usesSpheres());
    EXPECT_TRUE(ring.isFoundFrom({0.4, 0, 0})) << "also from between its parts";
}

// One over the density, summed over the chosen points of the side that is seen, each by its cosine here, is the irradiance.
TEST(MeshAim, PointsAreChosenAsOftenAsTheirDensitySays) {
    const scene::Object ring = objectOf(scene::makeTorus(0.5, 0.03, {64, 32}), testing::translation({1, 2, 3}));
    const MeshAim aim(ring);
    const dvec3 from(1.1, 2.6, 3), down(0, -1, 0);
    constexpr int kChoices = 400'000;
    double found = 0;
    for (int i = 0; i < kChoices; ++i) {
        const auto x = testing::quasirandom4(i);
        const auto way = aim.choose(from, x[0], {x[1], x[2]});
        ASSERT_TRUE(way);
        EXPECT_NEAR(glm::length(way->direction), 1, 1e-12);
        const dvec3 point = from + way->distance * way->direction, off = point - dvec3(1, 2, 3);
        const dvec3 onCircle = 0.5 * glm::normalize(dvec3(off.x, 0, off.z)), outward = glm::normalize(off - onCircle);
        EXPECT_NEAR(glm::distance(off, onCircle), 0.03, 0.001) << "it has faces";
        if (glm::dot(outward, way->direction) < 0) found += std::max(0.0, glm::dot(way->direction, down)) / (way->density * kChoices);
        if (i % 1000 == 0) {
            EXPECT_EQ(aim.density(from, way->direction, 2 * way->distance, 0.5), aim.density(from, way->direction, way->distance, 0.5) * 4);
        }
    }
    const double truth = glm::pi<double>() * testing::meshFormFactor(ring, from, down);
    EXPECT_GT(truth, 0.1);
    EXPECT_NEAR(found / truth, 1, 0.01) << "sides by the torus, which the mesh's faces follow to some degrees";
}

} // namespace
} // namespace shadowlab::radiosity
