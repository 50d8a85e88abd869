// The near plane moves out as far as what is in view allows, and never cuts anything off.
// SPDX-License-Identifier: MIT
#include "techniques/foundation/scene/query/view/depth_fit.h"

#include <gtest/gtest.h>

#include "techniques/foundation/scene/model/shapes.h"
#include "techniques/foundation/trace/judge/exact_visibility.h"
#include "tests/support/hard_scenes.h"
#include "tests/support/scenes.h"

namespace shadowlab {
namespace {

constexpr ivec2 kSize{64, 48};
constexpr double kAspect = 64.0 / 48.0;

scene::Scene oneBox(const dvec3& position) {
    scene::Scene scene;
    scene.materials.emplace_back();
    scene.camera.positionWorld = {0, 0, 10};
    scene.camera.targetWorld = {0, 0, 0};
    testing::addObject(scene, scene::makeBox({2, 2, 2}), testing::translation(position));
    return scene;
}

scene::Camera tight(const scene::Scene& scene) {
    return scene::withTightNear(scene.camera, scene, scene::objectBounds(scene), kAspect);
}

TEST(DepthFit, StopsJustBeforeTheNearestFace) {
    const scene::Scene scene = oneBox({0, 0, 0});
    EXPECT_NEAR(tight(scene).near, 9 * 0.99, 1e-12);
}

TEST(DepthFit, IgnoresWhatIsBesideOrBehindTheView) {
    scene::Scene scene = oneBox({0, 0, 0});
    testing::addObject(scene, scene::makeBox({1, 1, 1}), testing::translation({20, 0, 9}));
    testing::addObject(scene, scene::makeSphere(1, 32), testing::translation({0, 0, 15}));
    EXPECT_NEAR(tight(scene).near, 9 * 0.99, 1e-12);
}

TEST(DepthFit, StaysWhereItWasWhenSomethingReachesThrough) {
    const scene::Scene around = oneBox({0, 0, 10}); // the camera is inside the box
    EXPECT_NEAR(tight(around).near, 0.99, 1e-12);   // its walls are 1 m away
    scene::Scene through = oneBox({0, 0, 0});
    testing::addObject(through, scene::makeBox({0.02, 0.02, 2}),
                       testing::translation({0, 0, 9.5})); // a pole from the eye
    EXPECT_EQ(tight(through).near, through.camera.near);
}

TEST(DepthFit, WithoutAnythingInViewNothingChanges) {
    const scene::Scene scene = oneBox({0, 0, 50});
    EXPECT_EQ(tight(scene).near, scene.camera.near);
}

// What the eye sees lies behind the new plane: nearest hits over many scenes, seen from inside soups as well.
TEST(DepthFit, CutsNothingOff) {
    int pixels = 0, moved = 0;
    for (const testing::HardClass hardClass : testing::kHardClasses)
        for (unsigned number = 0; number < 5; ++number) {
            const scene::Scene scene = testing::hardScene(hardClass, number, false);
            const scene::Camera fitted = tight(scene);
            EXPECT_GE(fitted.near, scene.camera.near);
            moved += fitted.near > scene.camera.near;
            const trace::ExactVisibility judge(testing::snapshot(scene));
            const dvec3 forward = glm::normalize(scene.camera.targetWorld - scene.camera.positionWorld);
            for (int y = 0; y < kSize.y; ++y)
                for (int x = 0; x < kSize.x; ++x)
                    if (const auto hit = judge.eyeHit(scene.camera, dvec2(x, y) + 0.5, kSize)) {
                        EXPECT_GT(glm::dot(hit->positionWorld - scene.camera.positionWorld, forward), fitted.near);
                        ++pixels;
                    }
        }
    EXPECT_GT(pixels, 50000);
    EXPECT_GT(moved, 15);
}

} // namespace
} // namespace shadowlab
