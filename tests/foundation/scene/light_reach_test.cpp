// SPDX-License-Identifier: MIT
#include "techniques/foundation/scene/query/view/light_reach.h"

#include <gtest/gtest.h>

#include <glm/gtc/constants.hpp>

#include "techniques/foundation/scene/model/shapes.h"
#include "tests/support/scenes.h"

namespace shadowlab {
namespace {

/// Does the light reach what the scene's own camera sees, in a square picture?
bool mayLight(const scene::Scene& scene, const scene::Light& light) {
    const std::vector<scene::Bounds> bounds = scene::objectBounds(scene);
    return scene::mayLight(scene, light, bounds, scene.camera.positionWorld,
                           scene::clipFromView(scene.camera, 1.0) * scene::viewFromWorld(scene.camera), {});
}

/// A floor of 10 x 10 at y = 0, seen from (0, 3, 6).
scene::Light spot(const dvec3& positionWorld, const dvec3& directionWorld, double coneDegrees) {
    scene::Light light;
    light.type = scene::LightType::spot;
    light.positionWorld = positionWorld;
    light.directionWorld = glm::normalize(directionWorld);
    light.coneDegrees = coneDegrees;
    return light;
}

TEST(LightReach, ASpotReachesWhatIsInItsCone) {
    const scene::Scene scene = testing::floorScene();
    EXPECT_TRUE(mayLight(scene, spot({0, 2, 0}, {0, -1, 0}, 40)));
    EXPECT_FALSE(mayLight(scene, spot({0, 2, 0}, {0, 1, 0}, 40))) << "it shines at the sky";
    EXPECT_FALSE(mayLight(scene, spot({0, -2, 0}, {0, -1, 0}, 40))) << "it is below the floor and shines down";
    EXPECT_FALSE(mayLight(scene, spot({20, 2, 0}, {0, -1, 0}, 40))) << "it shines beside the floor";
}

TEST(LightReach, TheFloorIsNotItsBoxButWhatIsSeenOfIt) {
    scene::Scene scene = testing::floorScene();
    scene.camera.fovYDegrees = 20;
    // At x = 4.5 the floor is there, but out of view: at the origin, 6.7 m away, the view is 1.2 m wide to each side.
    EXPECT_FALSE(mayLight(scene, spot({4.5, 2, 0}, {0, -1, 0}, 20)));
    EXPECT_TRUE(mayLight(scene, spot({1.0, 2, 0}, {0, -1, 0}, 20)));
}

TEST(LightReach, AlmostGrazingIsReached) {
    scene::Scene scene = testing::floorScene();
    scene.camera.fovYDegrees = 100; // all of that edge is in view
    // The floor ends at x = 5; a cone of 90 degrees from 1 m above reaches 1 m aside. A millimetre is 50 times the margin, and
    // the square around the cone is no wider than the cone in this direction or by its diagonal, sqrt(2), in another.
    EXPECT_TRUE(mayLight(scene, spot({5.999, 1, 0}, {0, -1, 0}, 90)));
    EXPECT_FALSE(mayLight(scene, spot({5 + 1.01 * glm::root_two<double>(), 1, 0}, {0, -1, 0}, 90)));
}

TEST(LightReach, ARectReachesWhatIsBeforeIt) {
    const scene::Scene scene = testing::floorScene();
    scene::Light rect;
    rect.type = scene::LightType::rect;
    rect.positionWorld = {0, 2, 0};
    rect.edgeUWorld = {1, 0, 0};
    rect.edgeVWorld = {0, 0, -1}; // cross(x, -z) = +y: it shines up
    EXPECT_FALSE(mayLight(scene, rect));
    rect.edgeVWorld = {0, 0, 1};
    EXPECT_TRUE(mayLight(scene, rect));
}

TEST(LightReach, OtherLightsShineEverywhere) {
    const scene::Scene scene = testing::floorScene();
    EXPECT_TRUE(mayLight(scene, testing::pointLight({0, -5, 0})));
    EXPECT_TRUE(mayLight(scene, testing::directionalLight({0, 1, 0})));
}

TEST(LightReach, AnObjectOfManyTrianglesIsJudgedByItsBox) {
    scene::Scene scene = testing::floorScene();
    scene.objects.clear();
    testing::addObject(scene, scene::makeSphere(0.5, 32), testing::translation({0, 1, 0}));
    EXPECT_TRUE(mayLight(scene, spot({0, 4, 0}, {0, -1, 0}, 20)));
    EXPECT_FALSE(mayLight(scene, spot({3, 4, 0}, {0, -1, 0}, 20)));
}

} // namespace
} // namespace shadowlab
