// Volumes are kept while nothing moves that they depend on, and are never those of another place.
// SPDX-License-Identifier: MIT
#include "techniques/shadow_volume/cull/casters.h"

#include <gtest/gtest.h>

#include "techniques/foundation/scene/json/scene_json.h"
#include "tests/support/scenes.h"

namespace shadowlab {
namespace {

using shadow_volume::Casters;
using shadow_volume::CasterVolume;

void buildAll(Casters& casters, const scene::Scene& scene) {
    const scene::Snapshot snapshot = testing::snapshot(scene);
    while (!casters.buildNext(snapshot)) {
    }
}

/// How many volumes a change makes it build; all that it then has must be what one would have that starts from nothing.
std::size_t rebuiltFor(Casters& casters, const scene::Scene& scene) {
    buildAll(casters, scene);
    Casters fresh;
    buildAll(fresh, scene);
    EXPECT_EQ(casters.count(), fresh.count());
    for (int light = 0; light < static_cast<int>(scene.lights.size()); ++light) {
        const std::vector<CasterVolume>&kept = casters.of(light), &anew = fresh.of(light);
        EXPECT_EQ(kept.size(), anew.size());
        for (std::size_t c = 0; c < std::min(kept.size(), anew.size()); ++c) {
            EXPECT_EQ(kept[c].object, anew[c].object);
            EXPECT_EQ(kept[c].silhouette, anew[c].silhouette);
            EXPECT_EQ(kept[c].volume.topCap, anew[c].volume.topCap);
            EXPECT_EQ(kept[c].volume.topCapReversed, anew[c].volume.topCapReversed);
            EXPECT_EQ(kept[c].volume.sides, anew[c].volume.sides);
            EXPECT_EQ(kept[c].endWorld, anew[c].endWorld);
            EXPECT_EQ(kept[c].volume.bottomCap, anew[c].volume.bottomCap);
            EXPECT_EQ(kept[c].useful, anew[c].useful);
            EXPECT_EQ(kept[c].bounds.lowerWorld, anew[c].bounds.lowerWorld);
            EXPECT_EQ(kept[c].bounds.upperWorld, anew[c].bounds.upperWorld);
            EXPECT_EQ(kept[c].report.triangles, anew[c].report.triangles);
        }
    }
    return casters.takeRebuilt();
}

constexpr std::size_t kObjects = 4; // floor, box, sphere, torus

scene::Scene twoLights() {
    scene::Scene scene = testing::simpleScene();
    EXPECT_EQ(scene.objects.size(), kObjects);
    scene.lights = {testing::pointLight({2, 5, 3}), testing::directionalLight({-0.5, -1, 0.25})};
    return scene;
}

TEST(KeptVolumes, AreBuiltOnceAndAMovingEyeBuildsNone) {
    scene::Scene scene = twoLights();
    Casters casters;
    EXPECT_EQ(rebuiltFor(casters, scene), 2 * kObjects);
    for (const double x : {1.0, 2.0}) {
        scene.camera.positionWorld.x = x;
        EXPECT_EQ(rebuiltFor(casters, scene), 0u);
    }
}

TEST(KeptVolumes, OneLightThatMovesBuildsItsOwn) {
    scene::Scene scene = twoLights();
    Casters casters;
    buildAll(casters, scene);
    casters.takeRebuilt();
    scene.lights[0].positionWorld = {-1, 4, 1};
    scene.revisions.lights = scene::newRevision();
    const std::size_t rebuilt = rebuiltFor(casters, scene);
    EXPECT_GE(rebuilt, 2u);
    EXPECT_LE(rebuilt, kObjects) << "none of the other light, which stands";
    scene.lights[1].color = vec3(0.5f, 1, 1);
    scene.revisions.lights = scene::newRevision();
    EXPECT_EQ(rebuiltFor(casters, scene), 0u) << "a colour moves nothing";
}

// The signs of all triangles are what they were, so everything is.
TEST(KeptVolumes, ALightThatMovesByLittleBuildsNone) {
    scene::Scene scene = twoLights();
    Casters casters;
    buildAll(casters, scene);
    casters.takeRebuilt();
    scene.lights[0].positionWorld.x += 1e-9;
    scene.revisions.lights = scene::newRevision();
    EXPECT_EQ(rebuiltFor(casters, scene), 0u);
}

TEST(KeptVolumes, AnObjectThatMovesBuildsItsOwnAndOthersMayEndElsewhere) {
    scene::Scene scene = twoLights();
    Casters casters;
    buildAll(casters, scene);
    casters.takeRebuilt();
    scene.objects[3].worldFromObject = testing::translation({0, -3, 0}) * scene.objects[3].worldFromObject;
    scene.revisions.transforms = scene::newRevision();
    const auto end = casters.of(0)[1].endWorld;
    EXPECT_EQ(rebuiltFor(casters, scene), 1u)
        << "from the sun it looks the same, wherever it is; from the lamp it does not";
    EXPECT_NE(casters.of(0)[1].endWorld, end) << "the scene is larger than it was";
    scene.objects[3].worldFromObject *= scene::worldFromObjectOf(dvec3(1), {30, 0, 0}, dvec3(0));
    scene.revisions.transforms = scene::newRevision();
    EXPECT_EQ(rebuiltFor(casters, scene), 2u);
}

TEST(KeptVolumes, ObjectsAndLightsThatComeAndGo) {
    scene::Scene scene = twoLights();
    Casters casters;
    buildAll(casters, scene);
    casters.takeRebuilt();
    testing::addObject(scene, *scene.objects[2].mesh, testing::translation({1, 2, 1}));
    scene.revisions.geometry = scene::newRevision();
    EXPECT_EQ(rebuiltFor(casters, scene), 2u) << "the new one, for each light";
    scene.lights.push_back(testing::pointLight({-2, 3, 1}));
    scene.revisions.lights = scene::newRevision();
    EXPECT_EQ(rebuiltFor(casters, scene), kObjects + 1);
    scene.objects[1].castsShadow = false;
    scene.revisions.geometry = scene::newRevision();
    EXPECT_EQ(rebuiltFor(casters, scene), 0u) << "one less";
    scene.objects.erase(scene.objects.begin() + 3);
    scene.revisions.geometry = scene::newRevision();
    EXPECT_EQ(rebuiltFor(casters, scene), 3u) << "objects are known by their number: the last has a new one";
    scene.lights.clear();
    scene.revisions.lights = scene::newRevision();
    EXPECT_EQ(rebuiltFor(casters, scene), 0u);
}

// An object may change its mesh for another with as many triangles and the same signs.
TEST(KeptVolumes, AnotherMeshIsAnotherVolume) {
    scene::Scene scene = twoLights();
    Casters casters;
    buildAll(casters, scene);
    casters.takeRebuilt();
    scene::Mesh mesh = *scene.objects[1].mesh;
    scene.objects[1].mesh = std::make_shared<const scene::Mesh>(mesh);
    scene.revisions.geometry = scene::newRevision();
    EXPECT_EQ(rebuiltFor(casters, scene), 2u);
}

// While the volumes are being brought up to date the scene may change again.
TEST(KeptVolumes, AChangeBeforeAllAreBuilt) {
    scene::Scene scene = twoLights();
    Casters casters;
    buildAll(casters, scene);
    scene.lights[0].positionWorld = {-1, 4, 1};
    scene.lights[1].directionWorld = glm::normalize(dvec3(0.5, -1, 0.5));
    scene.revisions.lights = scene::newRevision();
    EXPECT_FALSE(casters.buildNext(testing::snapshot(scene)));
    scene.lights[0].positionWorld = {1, 4, -2};
    scene.revisions.lights = scene::newRevision();
    casters.takeRebuilt();
    EXPECT_GT(rebuiltFor(casters, scene), kObjects);
}

} // namespace
} // namespace shadowlab
