// What turns, turns as one: lights, their directions and edges, and the surfaces that are seen where they shine.
// SPDX-License-Identifier: MIT
#include "app/film/orbit.h"

#include <gtest/gtest.h>

#include "techniques/foundation/scene/load/load.h"
#include "tests/support/scenes.h"

namespace shadowlab::film {
namespace {

constexpr double kTolerance = 1e-12;

void expectNear(const dvec3& a, const dvec3& b) {
    EXPECT_LT(glm::length(a - b), kTolerance) << b.x << ' ' << b.y << ' ' << b.z;
}

scene::Snapshot lightsOfAllKinds() {
    scene::Scene scene = testing::simpleScene();
    scene.camera.targetWorld = {0.5, 1, -0.25};
    scene.lights.clear();
    for (const scene::LightType type : {scene::LightType::point, scene::LightType::directional, scene::LightType::spot,
                                        scene::LightType::rect, scene::LightType::sphere}) {
        scene::Light light;
        light.name = std::string(scene::toText(type));
        light.type = type;
        light.positionWorld = {1.0 + static_cast<double>(scene.lights.size()), 3, 2};
        light.directionWorld = glm::normalize(dvec3(0.3, -1, 0.2));
        light.edgeUWorld = {1, 0, 0.5};
        light.edgeVWorld = {0, 0.5, 1};
        scene.lights.push_back(light);
    }
    scene::addEmitterSurfaces(scene);
    return testing::snapshot(std::move(scene));
}

TEST(Orbit, FourQuarterTurnsReturn) {
    const scene::Snapshot start = lightsOfAllKinds();
    scene::Snapshot turned = start;
    scene::Camera camera = start->camera;
    for (int i = 0; i < 4; ++i) {
        turned = withLightsTurned(turned, 90);
        camera = film::turned(camera, 90);
        if (i == 1) {
            EXPECT_GT(glm::length(camera.positionWorld - start->camera.positionWorld), 1);
        }
    }
    for (std::size_t i = 0; i < start->lights.size(); ++i) {
        const scene::Light &a = turned->lights[i], &b = start->lights[i];
        expectNear(a.positionWorld, b.positionWorld);
        expectNear(a.directionWorld, b.directionWorld);
        expectNear(a.edgeUWorld, b.edgeUWorld);
        expectNear(a.edgeVWorld, b.edgeVWorld);
    }
    for (std::size_t i = 0; i < start->objects.size(); ++i)
        for (int c = 0; c < 4; ++c)
            expectNear(dvec3(turned->objects[i].worldFromObject[c]), dvec3(start->objects[i].worldFromObject[c]));
    expectNear(camera.positionWorld, start->camera.positionWorld);
    expectNear(camera.upWorld, start->camera.upWorld);
}

TEST(Orbit, AQuarterTurnIsThatOfTheRightHand) {
    scene::Scene scene = testing::simpleScene();
    scene.camera.targetWorld = {1, 5, 2};
    scene.lights = {testing::pointLight({4, 3, 2}), testing::directionalLight({1, 0, 0})};
    const scene::Snapshot turned = withLightsTurned(testing::snapshot(scene), 90);
    expectNear(turned->lights[0].positionWorld, {1, 3, -1}); // +x goes to -z
    expectNear(turned->lights[1].directionWorld, {0, 0, -1});
}

TEST(Orbit, HeightAndDistanceToTheAxisStay) {
    const scene::Snapshot start = lightsOfAllKinds();
    const dvec3 pivot = start->camera.targetWorld;
    const auto fromAxis = [&](const dvec3& p) { return glm::length(dvec2(p.x - pivot.x, p.z - pivot.z)); };
    for (const double degrees : {-720.5, -90.0, 1.0, 37.0, 180.0, 359.0}) {
        const scene::Snapshot turned = withLightsTurned(start, degrees);
        for (std::size_t i = 0; i < start->lights.size(); ++i) {
            EXPECT_NEAR(fromAxis(turned->lights[i].positionWorld), fromAxis(start->lights[i].positionWorld),
                        kTolerance);
            EXPECT_NEAR(turned->lights[i].positionWorld.y, start->lights[i].positionWorld.y, kTolerance);
            EXPECT_NEAR(glm::length(turned->lights[i].directionWorld), 1, kTolerance);
        }
        const scene::Camera camera = film::turned(start->camera, degrees);
        EXPECT_NEAR(fromAxis(camera.positionWorld), fromAxis(start->camera.positionWorld), kTolerance);
        EXPECT_EQ(camera.targetWorld, pivot);
    }
}

TEST(Orbit, EmitterSurfacesMoveWithTheirLight) {
    const scene::Snapshot start = lightsOfAllKinds(), turned = withLightsTurned(start, 73);
    int emitters = 0;
    for (std::size_t i = 0; i < start->objects.size(); ++i) {
        const scene::Object &before = start->objects[i], &after = turned->objects[i];
        if (before.emitterOfLight < 0) {
            EXPECT_EQ(before.worldFromObject, after.worldFromObject);
            continue;
        }
        ++emitters;
        // In the middle of its box stands the light, before and after.
        const auto light = static_cast<std::size_t>(before.emitterOfLight);
        for (const auto& [object, lights] : {std::pair(&before, &start->lights), std::pair(&after, &turned->lights)}) {
            const scene::Bounds bounds = scene::boundsWorld(*object);
            EXPECT_LT(glm::length(0.5 * (bounds.lowerWorld + bounds.upperWorld) - (*lights)[light].positionWorld),
                      1e-3);
        }
    }
    EXPECT_EQ(emitters, 2);
    EXPECT_NE(turned->revisions.lights, start->revisions.lights);
    EXPECT_NE(turned->revisions.transforms, start->revisions.transforms);
    EXPECT_EQ(turned->revisions.geometry, start->revisions.geometry);
}

TEST(Orbit, NoTurnIsTheSameScene) {
    const scene::Snapshot start = lightsOfAllKinds();
    EXPECT_EQ(withLightsTurned(start, 0), start);
}

} // namespace
} // namespace shadowlab::film
