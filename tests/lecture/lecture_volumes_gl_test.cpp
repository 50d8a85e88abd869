// The lecture's shadow volumes against the truth: right where the lecture says so, and wrong where it says so.
// SPDX-License-Identifier: MIT
#include "app/context/assets.h"
#include "techniques/foundation/scene/load/load.h"
#include "techniques/foundation/scene/model/shapes.h"
#include "tests/support/gl_fixture.h"
#include "tests/support/scenes.h"
#include "tests/support/truth_comparison.h"

namespace shadowlab {
namespace {

using testing::compareWithTruth;
using testing::kTiePx;
using testing::TruthComparison;
using LectureVolumesTest = testing::GlTest;

const std::string kZPass = "lecture-zpass", kZFail = "lecture-zfail";
constexpr ivec2 kSize{320, 180};

// Where two sides of one volume meet, a pixel in some 30,000 may be met by neither: the far ends are rounded to floats.
constexpr double kCrackShare = 3e-5;

scene::Snapshot builtIn(const std::string& name) {
    return scene::loadScene(name, {.assetsRoot = context::assetsRoot(), .allowed = {}, .limits = {}});
}

// Casters there are closed, and the eye is in the light.
TEST_F(LectureVolumesTest, BothAreExactWhereCastersAreClosedAndTheEyeIsLit) {
    for (const std::string& technique : {kZPass, kZFail}) {
        TruthComparison all;
        for (const char* name : {"sphere-on-plane", "still-life", "three-lights"}) {
            const scene::Snapshot snapshot = builtIn(name);
            for (int light = 0; light < static_cast<int>(snapshot->lights.size()); ++light)
                all += compareWithTruth(snapshot, technique, {}, kSize, light, kTiePx);
        }
        std::cout << technique << ": " << all << "\n";
        EXPECT_GE(all.compared, 5 * kSize.x * kSize.y);
        EXPECT_GT(all.lit, 50000);
        EXPECT_GT(all.shadowed, 5000);
        EXPECT_LE(all.wrong(), kCrackShare * all.compared) << technique << ": " << all;
    }
}

// "Z-pass generates incorrect results when the view point itself is in the shadow", and z-fail correct ones.
TEST_F(LectureVolumesTest, WithTheEyeInShadowZPassIsReversedAndZFailIsRight) {
    const scene::Snapshot snapshot = builtIn("eye-in-shadow");
    const TruthComparison zpass = compareWithTruth(snapshot, kZPass, {}, kSize, 0, kTiePx);
    const TruthComparison zfail = compareWithTruth(snapshot, kZFail, {}, kSize, 0, kTiePx);
    EXPECT_GT(zfail.lit, 10000);
    EXPECT_GT(zfail.shadowed, 10000);
    EXPECT_LE(zfail.wrong(), kCrackShare * zfail.compared) << zfail;
    EXPECT_GT(zpass.falseShadow, zpass.lit / 2) << zpass;
    EXPECT_GT(zpass.falseLit, zpass.shadowed / 2) << zpass;
}

/// A square sheet of 2 m that hovers 1 m over a floor, under a lamp.
scene::Snapshot sheetOverFloor() {
    scene::Scene scene = testing::floorScene();
    testing::addObject(scene, scene::makeQuad({2, 2}), testing::translation({0, 1, 0}));
    scene.lights.push_back(testing::pointLight({0.5, 4, 0.25}));
    return testing::snapshot(scene);
}

// Z-pass extends the boundary of an open mesh as well. Z-fail's generation algorithm asks for two surfaces at each edge: the sheet
// has a top cap, and neither sides nor a bottom cap.
TEST_F(LectureVolumesTest, AnOpenCasterIsRightInZPassAndHasNoSidesInZFail) {
    const TruthComparison zpass = compareWithTruth(sheetOverFloor(), kZPass, {}, kSize, 0, kTiePx);
    const TruthComparison zfail = compareWithTruth(sheetOverFloor(), kZFail, {}, kSize, 0, kTiePx);
    EXPECT_GT(zpass.lit, 10000);
    EXPECT_GT(zpass.shadowed, 1000);
    EXPECT_LE(zpass.wrong(), kCrackShare * zpass.compared + 1) << zpass;
    EXPECT_GT(zfail.wrong(), 1000) << zfail;
}

// d = 0.5 m is too short for a ball whose lowest point is 1 m above the floor.
TEST_F(LectureVolumesTest, AShortExtrusionEndsBeforeTheReceiver) {
    scene::Scene scene = testing::floorScene();
    testing::addObject(scene, scene::makeSphere(0.8, 32), testing::translation({0, 1.8, 0}));
    scene.lights.push_back(testing::pointLight({0.5, 5, 1}));
    const scene::Snapshot snapshot = testing::snapshot(scene);
    const TruthComparison without = compareWithTruth(snapshot, kZFail, {}, kSize, 0, kTiePx);
    const TruthComparison far = compareWithTruth(snapshot, kZFail, {"extrusion=10"}, kSize, 0, kTiePx);
    const TruthComparison near = compareWithTruth(snapshot, kZFail, {"extrusion=0.5"}, kSize, 0, kTiePx);
    EXPECT_GT(without.lit, 10000);
    EXPECT_GT(without.shadowed, 500);
    EXPECT_LE(without.wrong(), 1) << without;
    EXPECT_LE(far.wrong(), 1) << far;
    EXPECT_GT(near.falseLit, near.shadowed * 9 / 10) << near;
    EXPECT_EQ(near.falseShadow, 0) << near;
}

// With the lamp behind the eye, rays from shadowed points run on within the volume: they leave it through its bottom cap alone.
TEST_F(LectureVolumesTest, ZFailIsRightWhereRaysLeaveThroughTheBottomCap) {
    scene::Scene scene = testing::floorScene();
    scene.camera.targetWorld = {0, 0.5, 0};
    testing::addObject(scene, scene::makeSphere(0.8, 32), testing::translation({0, 1.2, 2}));
    scene.lights.push_back(testing::pointLight({3, 4, 7})); // to the right of the eye, so that not all shadow is hidden
    for (const char* extrusion : {"extrusion=0", "extrusion=50"}) {
        const auto zfail = compareWithTruth(testing::snapshot(scene), kZFail, {extrusion}, kSize, 0, kTiePx);
        EXPECT_GT(zfail.lit, 10000);
        EXPECT_GT(zfail.shadowed, 500);
        EXPECT_LE(zfail.wrong(), 1) << zfail;
    }
}

} // namespace
} // namespace shadowlab
