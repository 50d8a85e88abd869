// Where a scene's camera names no near plane, none of what is seen is cut off, and ordinary scenes keep the 0.1 m they had.
// SPDX-License-Identifier: MIT
#include "techniques/foundation/scene/query/view/default_near.h"

#include "techniques/foundation/scene/json/write_scene.h"
#include "techniques/foundation/scene/model/edit_scene.h"
#include "tests/foundation/scene/scene_files.h"

namespace shadowlab::scene {
namespace {

std::shared_ptr<const Scene> sceneWith(const std::string& camera, const std::string& objects) {
    const TempFolder folder;
    return loadScene(folder.write("s.json", "{\"camera\": {" + camera + "}, \"objects\": [" + objects + "]}").string(),
                     {});
}

TEST(DefaultNear, IsATenthOfAMetreWhereNothingIsNearer) {
    EXPECT_EQ(sceneWith(R"("position": [0, 2, 6], "target": [0, 1, 0])", R"({"shape": "box", "size": [1, 1, 1]})")
                  ->camera.near,
              0.1);
    EXPECT_EQ(sceneWith(R"("position": [0, 2, 6], "target": [0, 1, 0])", "")->camera.near, 0.1);
}

TEST(DefaultNear, IsBeforeASmallThing) {
    // A ball of 6 mm, 34 mm away: its nearest point is at 28 mm.
    const auto scene =
        sceneWith(R"("position": [0, 0, 0.034], "target": [0, 0, 0])", R"({"shape": "sphere", "radius": 0.006})");
    EXPECT_GT(scene->camera.near, 0.0003) << "no nearer than a hundredth of the way: depth precision";
    EXPECT_LT(scene->camera.near, 0.028 / 5) << "the camera may come closer";
}

TEST(DefaultNear, IsBeforeWhatReachesPastTheEyeOfALargeScene) {
    // The eye stands 3 cm above a floor of 10 m and looks over it; straight below it, out of view, lies nothing nearer.
    const auto scene =
        sceneWith(R"("position": [0, 0.03, 5], "target": [0, 0, 0])", R"({"shape": "quad", "size": [20, 20]})");
    EXPECT_GE(scene->camera.near, 0.01);
    EXPECT_LT(scene->camera.near, 0.03 / std::tan(0.4)) << "the lower edge of the picture meets the floor there";
}

TEST(DefaultNear, WhatIsWrittenCounts) {
    const std::string ball = R"({"shape": "sphere", "radius": 0.006})";
    EXPECT_EQ(sceneWith(R"("position": [0, 0, 0.034], "target": [0, 0, 0], "near": 0.1)", ball)->camera.near, 0.1);
    const auto scene = sceneWith(R"("position": [0, 0, 0.5], "target": [0, 0, 0], "far": 0.04)", ball);
    EXPECT_LT(scene->camera.near, scene->camera.far) << "a far plane before the default of near is no fault";
}

TEST(DefaultNear, ComesBackFromAFile) {
    const auto scene =
        sceneWith(R"("position": [0, 0, 0.034], "target": [0, 0, 0])", R"({"shape": "sphere", "radius": 0.006})");
    const TempFolder folder;
    Camera closer = scene->camera;
    closer.positionWorld.z = 0.02; // there the reader would choose another near plane than this camera has
    for (const Camera& camera : {scene->camera, closer}) {
        const auto again = loadScene(folder.write("again.json", sceneText(*scene, camera, folder.path())).string(), {});
        EXPECT_EQ(again->camera, camera);
    }
}

} // namespace
} // namespace shadowlab::scene
