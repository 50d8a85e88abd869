// Where volumes end: beyond everything, reached from the whole caster, and as near as one side of the scene allows.
// SPDX-License-Identifier: MIT
#include "techniques/shadow_volume/count/volume_end.h"

#include <gtest/gtest.h>

#include <random>

#include "tests/support/hard_scenes.h"
#include "tests/support/scenes.h"

namespace shadowlab {
namespace {

using shadow_volume::endPlaneWorld;
using shadow_volume::pushedWorld;

scene::Bounds box(const dvec3& lower, const dvec3& upper) {
    scene::Bounds bounds;
    bounds.include(lower);
    bounds.include(upper);
    return bounds;
}

const scene::Bounds kScene = box({-10, 0, -10}, {10, 5, 10});
const scene::Bounds kCaster = box({-1, 1, -1}, {1, 2, 1});

TEST(VolumeEnd, ASteepLightEndsBelowTheFloorAndAFlatOneAtAWall) {
    for (const scene::Light& light : {testing::directionalLight({0.5, -1, 0.25}), testing::pointLight({2, 5, 3})}) {
        const auto plane = endPlaneWorld(kCaster, light, kScene);
        ASSERT_TRUE(plane);
        EXPECT_EQ(dvec3(*plane), dvec3(0, -1, 0));
        EXPECT_LT(plane->w, 0) << "the floor itself is not beyond";
    }
    const auto plane = endPlaneWorld(kCaster, testing::directionalLight({1, -0.01, 0}), kScene);
    ASSERT_TRUE(plane);
    EXPECT_EQ(dvec3(*plane), dvec3(1, 0, 0));
}

TEST(VolumeEnd, ThereIsNoneForALightWithinTheCaster) {
    EXPECT_FALSE(endPlaneWorld(kCaster, testing::pointLight({0, 1.5, 0}), kScene));
    // A hair above the caster's lowest corner: what is extruded from there goes nearly sideways.
    EXPECT_FALSE(endPlaneWorld(kCaster, testing::pointLight({0, 2.0 + 1e-9, 0}), kScene));
}

TEST(VolumeEnd, NothingOfTheSceneLiesBeyondAndEveryVertexReachesIt) {
    int planes = 0, none = 0;
    for (const bool directional : {false, true})
        for (const testing::HardClass hardClass : testing::kHardClasses)
            for (unsigned i = 0; i < 20; ++i) {
                const scene::Scene scene = testing::hardScene(hardClass, i, directional);
                scene::Bounds all;
                for (const scene::Bounds& bounds : scene::objectBounds(scene))
                    all.include(bounds);
                for (const scene::Object& object : scene.objects) {
                    const auto plane = endPlaneWorld(scene::boundsWorld(object), scene.lights[0], all);
                    if (!plane) {
                        ++none;
                        continue;
                    }
                    ++planes;
                    for (int corner = 0; corner < 8; ++corner)
                        ASSERT_LT(glm::dot(*plane, dvec4(all.corner(corner), 1.0)), 0);
                    const dvec4 light = scene::homogeneousPositionWorld(scene.lights[0]);
                    for (const vec3& positionMesh : object.mesh->positionsMesh) {
                        const dvec3 from = transformPoint(scene::worldFromMesh(object), dvec3(positionMesh));
                        const dvec3 to =
                            dvec3(pushedWorld(from, scene.lights[0], {.planeWorld = plane, .distance = {}}));
                        ASSERT_NEAR(glm::dot(*plane, dvec4(to, 1.0)), 0, 1e-9);
                        ASSERT_GT(glm::dot(to - from, from * light.w - dvec3(light)), 0) << "toward the light";
                    }
                }
            }
    EXPECT_GT(planes, 200);
    EXPECT_GT(none, 20) << "lights within casters are among the hard scenes";
}

} // namespace
} // namespace shadowlab
