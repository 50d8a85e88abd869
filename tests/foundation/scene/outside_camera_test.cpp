// The position of the second camera: objects, eye and lights are in its picture, in any scene and at any scale.
// SPDX-License-Identifier: MIT
#include "techniques/foundation/scene/query/outside_camera.h"

#include <gtest/gtest.h>

#include <cmath>

#include <glm/gtc/constants.hpp>

#include "techniques/foundation/scene/model/shapes.h"
#include "tests/support/scenes.h"

namespace shadowlab::scene {
namespace {

constexpr double kWide = 16.0 / 9;

/// Place in the picture, -1..1 across and up; far outside for what lies before the near plane.
dvec2 placeIn(const Camera& camera, double aspect, const dvec3& positionWorld) {
    const dvec4 clip = clipFromView(camera, aspect) * viewFromWorld(camera) * dvec4(positionWorld, 1.0);
    return clip.z < -clip.w ? dvec2(1e9) : dvec2(clip) / clip.w;
}

bool isInFrame(const Camera& camera, double aspect, const dvec3& positionWorld) {
    const dvec2 place = placeIn(camera, aspect, positionWorld);
    return std::max(std::abs(place.x), std::abs(place.y)) <= 1;
}

Scene sceneWithSun() {
    Scene scene = testing::simpleScene();
    scene.lights.push_back(testing::directionalLight({0.5, -1, 0.25}));
    return scene;
}

TEST(ViewCorners, OfTheNearPlaneAreNearTimesTheTangent) {
    Camera camera;
    camera.positionWorld = {0, 0, 0};
    camera.targetWorld = {0, 0, -1}; // view space is world space
    camera.fovYDegrees = 60;
    camera.near = 0.25;
    const auto corners = viewCorners(camera, 2.0, camera.near);
    const double y = 0.25 * std::tan(glm::pi<double>() / 6), x = 2 * y;
    const dvec3 expected[] = {{-x, y, -0.25}, {x, y, -0.25}, {x, -y, -0.25}, {-x, -y, -0.25}};
    for (std::size_t i = 0; i < 4; ++i)
        EXPECT_LT(glm::length(corners[i] - expected[i]), 1e-15) << i;
}

TEST(ViewCorners, AreTheCornersOfThePicture) {
    Camera camera;
    camera.positionWorld = {3, 2, 1};
    camera.targetWorld = {-1, 0.5, 0};
    const dvec2 expected[] = {{-1, 1}, {1, 1}, {1, -1}, {-1, -1}};
    for (const double depth : {camera.near, 7.0}) {
        const auto corners = viewCorners(camera, kWide, depth);
        for (std::size_t i = 0; i < 4; ++i)
            EXPECT_LT(glm::length(placeIn(camera, kWide, corners[i] + 1e-9 * (corners[i] - camera.positionWorld)) -
                                  expected[i]),
                      1e-6);
    }
}

TEST(OutsideCamera, HasThingsEyeAndLightsInItsPicture) {
    const Scene scene = sceneWithSun();
    const Bounds things = thingsBounds(scene);
    const ArrowPlace arrow = arrowPlace(things, scene.lights[1]);
    for (const double aspect : {kWide, 4.0 / 3, 8.0 / 9}) {
        const Camera camera = outsideCameraFor(scene, scene.camera, aspect);
        ASSERT_TRUE(hasView(camera));
        std::vector<dvec3> points = {scene.camera.positionWorld, scene.lights[0].positionWorld, arrow.tipWorld,
                                     arrow.tipWorld - arrow.length * scene.lights[1].directionWorld};
        for (int i = 0; i < 8; ++i)
            points.push_back(things.corner(i));
        const double depth = glm::length(0.5 * (things.lowerWorld + things.upperWorld) - scene.camera.positionWorld);
        for (const dvec3& corner : viewCorners(scene.camera, aspect, depth))
            points.push_back(corner);
        double farthestOut = 0;
        for (std::size_t i = 0; i < points.size(); ++i) {
            const dvec2 place = placeIn(camera, aspect, points[i]);
            EXPECT_LE(std::max(std::abs(place.x), std::abs(place.y)), 0.85 + 1e-9) << aspect << ' ' << i;
            farthestOut = std::max({farthestOut, std::abs(place.x), std::abs(place.y)});
        }
        EXPECT_GE(farthestOut, 0.85 - 1e-9) << aspect; // it stands as near as that allows
    }
}

TEST(OutsideCamera, LargeFloorsAndWallsDoNotPushItAway) {
    Scene scene = sceneWithSun();
    const Camera before = outsideCameraFor(scene, scene.camera);
    for (const double side : {240.0, 1e6}) {
        Scene large = scene;
        large.objects[0].mesh = std::make_shared<const Mesh>(makeQuad({side, side}));
        Bounds all;
        for (const Bounds& box : objectBounds(large))
            all.include(box);
        ASSERT_GT(glm::length(all.upperWorld - all.lowerWorld), side); // what would push a camera for all of it
        const Camera camera = outsideCameraFor(large, large.camera);
        EXPECT_LT(glm::length(camera.positionWorld - before.positionWorld), 1e-9) << side;
    }
    // A light far beyond everything does not either.
    scene.lights.push_back(testing::pointLight({900, 2000, 0}));
    EXPECT_LT(glm::length(outsideCameraFor(scene, scene.camera).positionWorld - before.positionWorld), 1e-9);
}

TEST(OutsideCamera, GoesToTheOtherSideOfAWall) {
    Scene scene = testing::simpleScene();
    const Camera open = outsideCameraFor(scene, scene.camera);
    // A wall in the plane x = -5, before the place it stood at; it reaches from behind the eye to behind the things.
    ASSERT_LT(open.positionWorld.x, -5);
    dmat4 upright(1.0);
    upright[0] = {0, 1, 0, 0};
    upright[1] = {-1, 0, 0, 0};
    upright[3] = {-5, 5, 0, 1};
    testing::addObject(scene, makeQuad({40, 60}), upright);
    const Camera walled = outsideCameraFor(scene, scene.camera);
    EXPECT_GT(walled.positionWorld.x, -5);
}

TEST(OutsideCamera, SeesArrowsFromTheSide) {
    Scene scene = testing::simpleScene();
    const Camera first = outsideCameraFor(scene, scene.camera);
    scene.lights = {testing::directionalLight(first.targetWorld - first.positionWorld)};
    const Camera camera = outsideCameraFor(scene, scene.camera);
    const dvec3 forward = glm::normalize(camera.targetWorld - camera.positionWorld);
    EXPECT_LE(std::abs(glm::dot(forward, scene.lights[0].directionWorld)), 0.8);
}

TEST(OutsideCamera, ScalesAndMovesWithTheScene) {
    const Scene scene = sceneWithSun();
    const Camera camera = outsideCameraFor(scene, scene.camera);
    for (const double scale : {1e-3, 1e4}) {
        Scene scaled = scene;
        scaled.camera.positionWorld *= scale;
        scaled.camera.targetWorld *= scale;
        for (Light& light : scaled.lights)
            light.positionWorld *= scale;
        for (Object& object : scaled.objects)
            object.worldFromObject = dmat4(dmat3(scale)) * object.worldFromObject;
        const Camera there = outsideCameraFor(scaled, scaled.camera);
        EXPECT_LT(glm::length(there.positionWorld - scale * camera.positionWorld), 1e-9 * scale);
        EXPECT_NEAR(there.near, scale * camera.near, 1e-12 * scale);
    }
    const dvec3 offset(1e6, -1e6, 1e6);
    const Camera there = outsideCameraFor(testing::moved(scene, offset), testing::moved(scene, offset).camera);
    EXPECT_LT(glm::length(there.positionWorld - offset - camera.positionWorld), 1e-7); // 2^-53 of 1e6, a few times
}

TEST(OutsideCamera, NeedsNeitherObjectsNorLights) {
    Scene scene = testing::simpleScene();
    scene.lights.clear();
    EXPECT_TRUE(hasView(outsideCameraFor(scene, scene.camera)));
    scene.objects.clear();
    const Camera camera = outsideCameraFor(scene, scene.camera);
    ASSERT_TRUE(hasView(camera));
    EXPECT_TRUE(isInFrame(camera, kWide, scene.camera.positionWorld));
    EXPECT_TRUE(isInFrame(camera, kWide, scene.camera.targetWorld));
}

} // namespace
} // namespace shadowlab::scene
