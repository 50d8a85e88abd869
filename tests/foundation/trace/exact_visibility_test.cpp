// The judge itself against closed forms: where a shadow must lie by geometry alone.
// SPDX-License-Identifier: MIT
#include "techniques/foundation/trace/judge/exact_visibility.h"

#include <gtest/gtest.h>

#include "techniques/foundation/scene/model/shapes.h"
#include "tests/support/scenes.h"

namespace shadowlab {
namespace {

using trace::Visibility;

/// A floor seen from straight above, so that a pixel is a place on it.
scene::Scene fromAbove() {
    scene::Scene scene = testing::floorScene();
    scene.camera.positionWorld = {0, 20, 0};
    scene.camera.targetWorld = {0, 0, 0};
    scene.camera.upWorld = {0, 0, -1};
    scene.camera.fovYDegrees = 28;
    return scene;
}

// CASES C.2: a square of half-size s at height q under a light at height h throws a square of half-size s h / (h - q).
TEST(ExactVisibility, ASquareParallelToTheFloorThrowsASquare) {
    scene::Scene scene = fromAbove();
    testing::addObject(scene, scene::makeQuad({1, 1}), testing::translation({0, 1, 0}));
    scene.lights.push_back(testing::pointLight({0.3, 4, -0.2}));
    const trace::ExactVisibility judge(testing::snapshot(scene));
    const ivec2 size{400, 400};
    int shadowed = 0, compared = 0;
    for (int y = 0; y < size.y; ++y)
        for (int x = 0; x < size.x; ++x) {
            const auto hit = judge.eyeHit(scene.camera, dvec2(x, y) + 0.5, size);
            ASSERT_TRUE(hit);
            if (hit->object != 0) continue; // the square itself hides a part of its shadow
            const dvec2 fromCentre(hit->positionWorld.x + 0.1, hit->positionWorld.z - 0.2 / 3);
            const double outside = std::max(std::abs(fromCentre.x), std::abs(fromCentre.y)) - 2.0 / 3;
            if (std::abs(outside) < 1e-9) continue;
            const bool inShadow = judge.visibility(*hit, scene.camera, 0) == Visibility::shadowed;
            ASSERT_EQ(inShadow, outside < 0) << hit->positionWorld.x << ", " << hit->positionWorld.z;
            shadowed += inShadow;
            ++compared;
        }
    EXPECT_GT(shadowed, 500);
    EXPECT_GT(compared - shadowed, 50000);
}

// CASES C.1: the shadow of a sphere on a plane is a conic. The mesh is inscribed, so its shadow lies inside the ellipse
// by at most r (1 - cos(pi / N)), magnified.
TEST(ExactVisibility, ASphereThrowsAnEllipse) {
    scene::Scene scene = fromAbove();
    testing::addObject(scene, scene::makeSphere(0.5, 256), testing::translation({0, 1, 0}));
    const dvec3 light(2, 4, 1);
    scene.lights.push_back(testing::pointLight(light));
    const trace::ExactVisibility judge(testing::snapshot(scene));
    const double a = 0.8475655414, b = 0.6761234038;
    const dvec2 centre(-0.7428571429, -0.3714285714), along = glm::normalize(centre);
    const ivec2 size{200, 200};
    int shadowed = 0, compared = 0;
    for (int y = 0; y < size.y; ++y)
        for (int x = 0; x < size.x; ++x) {
            const auto hit = judge.eyeHit(scene.camera, dvec2(x, y) + 0.5, size);
            if (!hit || hit->object != 0) continue;
            const dvec2 d = dvec2(hit->positionWorld.x, hit->positionWorld.z) - centre;
            const double u = glm::dot(d, along) / a, v = (d.x * along.y - d.y * along.x) / b;
            const double radius = std::sqrt(u * u + v * v);
            if (radius > 0.998 && radius < 1.0001) continue; // the band of the inscribed mesh
            const bool inShadow = judge.visibility(*hit, scene.camera, 0) == Visibility::shadowed;
            ASSERT_EQ(inShadow, radius < 1) << hit->positionWorld.x << ", " << hit->positionWorld.z;
            shadowed += inShadow;
            ++compared;
        }
    EXPECT_GT(shadowed, 300);
    EXPECT_GT(compared - shadowed, 20000);
}

TEST(ExactVisibility, ContactIsNoShadowAndTheOwnTriangleNeither) {
    scene::Scene scene = testing::floorScene();
    testing::addObject(scene, scene::makeQuad({10, 10}));                                     // the floor again
    testing::addObject(scene, scene::makeBox({1, 1, 1}), testing::translation({2, 0.5, -2})); // stands on it
    scene.lights.push_back(testing::pointLight({0, 5, 2}));
    const trace::ExactVisibility judge(testing::snapshot(scene));
    const auto hit = judge.eyeHit(scene.camera, {160.5, 150.5}, {320, 240});
    ASSERT_TRUE(hit);
    EXPECT_EQ(judge.visibility(*hit, scene.camera, 0), Visibility::lit);
    EXPECT_EQ(judge.crossings(*hit, 0), 0);
}

TEST(ExactVisibility, GatesComeBeforeReceiving) {
    scene::Scene scene = testing::floorScene();
    scene.objects[0].receivesShadow = false;
    scene.lights.push_back(testing::pointLight({0, -5, 0}));
    const trace::ExactVisibility judge(testing::snapshot(scene));
    EXPECT_EQ(judge.at(scene.camera, {160.5, 150.5}, {320, 240}, 0), Visibility::turnedAway);
    EXPECT_EQ(judge.at(scene.camera, {160.5, 0.5}, {320, 240}, 0), Visibility::noSurface);
}

} // namespace
} // namespace shadowlab
