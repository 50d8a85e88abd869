// Why a picture shows no surface: each reason, what to change, and that following the advice helps.
// SPDX-License-Identifier: MIT
#include "techniques/foundation/scene/query/view/empty_view.h"

#include "techniques/foundation/scene/model/shapes.h"
#include "tests/foundation/scene/scene_files.h"
#include "tests/support/scenes.h"

namespace shadowlab::scene {
namespace {

constexpr ivec2 kSize{640, 360};

/// A box of 1 m at a place; the eye is at the origin and looks along -z.
Scene boxAt(const dvec3& position, double size = 1) {
    Scene scene;
    scene.materials.emplace_back();
    scene.camera.positionWorld = dvec3(0);
    scene.camera.targetWorld = {0, 0, -10};
    testing::addObject(scene, makeBox(dvec3(size)), testing::translation(position));
    return scene;
}

std::string why(const Scene& scene) { return whyNothingIsSeen(scene, scene.camera, kSize); }

void expectSaid(const std::string& text, const std::vector<std::string>& parts) {
    for (const std::string& part : parts)
        EXPECT_TRUE(contains(text, part)) << part << " in: " << text;
}

TEST(EmptyView, NothingIsSaidOfWhatIsSeen) {
    EXPECT_EQ(why(boxAt({0, 0, -5})), "");
    EXPECT_EQ(why(boxAt({0, 0, 0})), "") << "from inside";
    EXPECT_EQ(why(boxAt({0, 0, -5}, 100)), "") << "it reaches past the eye";
}

TEST(EmptyView, BehindTheCamera) {
    Scene scene = boxAt({0, 0, 5});
    expectSaid(why(scene), {"the only object lies behind the camera", "180 degrees off", "\"target\": [0, 0, 5]"});
    scene.camera.targetWorld = {0, 0, 5};
    EXPECT_EQ(why(scene), "");
}

TEST(EmptyView, OutsideOfTheFieldOfView) {
    Scene scene = boxAt({20, 0, -5});
    expectSaid(why(scene),
               {"outside of its field of view", "76 degrees off", "\"target\": [20, 0, -5]", "\"fovYDegrees\""});
    scene.camera.targetWorld = {20, 0, -5};
    EXPECT_EQ(why(scene), "");
}

TEST(EmptyView, NearerThanTheNearPlane) {
    Scene scene = boxAt({0, 0, -0.034}, 0.012);
    scene.camera.near = 0.1;
    expectSaid(why(scene), {"nearer than its near plane, 0.1 m", "\"near\" to less than 0.04", "to 0.004"});
    scene.camera.near = 0.004;
    EXPECT_EQ(why(scene), "");
}

TEST(EmptyView, TooSmallForAPixel) {
    // 1 mm at 100 m: a pixel is 2 * 100 * tan(22.5 degrees) / 360 = 0.23 m. It stands beside the pixels' centres.
    Scene scene = boxAt({0, 0, -100}, 0.001);
    expectSaid(why(scene), {"too small to cover a pixel's centre", "pixels across, 100 m away", "times nearer to"});
    scene.camera.positionWorld = {0, 0, -99.99};
    scene.camera.targetWorld = {0, 0, -100};
    scene.camera.near = 1e-4;
    EXPECT_EQ(why(scene), "");
}

TEST(EmptyView, SeveralReasons) {
    Scene scene = boxAt({0, 0, 5});
    testing::addObject(scene, makeBox(dvec3(1)), testing::translation({20, 0, -5}));
    testing::addObject(scene, makeBox(dvec3(1)), testing::translation({-20, 0, -5}));
    expectSaid(why(scene), {"of 3 objects 1 lies behind the camera, 2 lie outside of its field of view"});
    expectSaid(whyNothingIsSeen(Scene{}, Camera{}, kSize), {"has no objects"});
}

} // namespace
} // namespace shadowlab::scene
