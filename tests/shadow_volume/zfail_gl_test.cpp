// Depth-fail shadow volumes against the exact judge, on scenes made to break them, and the naive variants that must
// fail.
// SPDX-License-Identifier: MIT
#include "techniques/foundation/scene/model/shapes.h"
#include "tests/support/gl_fixture.h"
#include "tests/support/hard_scenes.h"
#include "tests/support/scenes.h"
#include "tests/support/truth_comparison.h"

namespace shadowlab {
namespace {

using testing::compareWithTruth;
using testing::HardClass;
using testing::TruthComparison;
using ZFailTest = testing::GlTest;

constexpr ivec2 kSize{160, 120};

using testing::kTiePx;

TruthComparison overClass(HardClass hardClass, const std::vector<std::string>& settings, int scenes) {
    TruthComparison sum;
    for (int i = 0; i < scenes; ++i) {
        const auto scene = testing::snapshot(testing::hardScene(hardClass, static_cast<unsigned>(i), false));
        const TruthComparison one = compareWithTruth(scene, "shadow-volume-zfail", settings, kSize, 0, kTiePx);
        sum += one;
    }
    return sum;
}

// What hard_classes_gl_test.cpp finds exact: the same comparison must see each classical fault, or it proves nothing.
TEST_F(ZFailTest, WithoutCapsItIsWrong) {
    const TruthComparison sum = overClass(HardClass::torus, {"caps=false"}, 4);
    EXPECT_GT(sum.wrong(), sum.compared / 1000) << sum;
}
TEST_F(ZFailTest, WithLequalItFightsWithItsOwnSurface) {
    const TruthComparison sum = overClass(HardClass::soup, {"depth-test=lequal"}, 4);
    EXPECT_GT(sum.falseShadow, sum.compared / 100) << sum;
}
TEST_F(ZFailTest, WithoutWrappingItLosesCounts) {
    const TruthComparison sum = overClass(HardClass::torus, {"wrap=false"}, 4);
    EXPECT_GT(sum.wrong(), sum.compared / 1000) << sum;
}

TEST_F(ZFailTest, TwoPassesGiveTheSamePixelsAsOne) {
    for (const HardClass hardClass : testing::kHardClasses) {
        const auto scene = testing::snapshot(testing::hardScene(hardClass, 3, false));
        const auto one = testing::renderVisibility(scene, "shadow-volume-zfail", {}, kSize, 0);
        const auto two = testing::renderVisibility(scene, "shadow-volume-zfail", {"two-sided=false"}, kSize, 0);
        EXPECT_EQ(one.greyAlpha, two.greyAlpha) << toText(hardClass);
    }
}

TEST_F(ZFailTest, MovedFarFromTheOrigin) {
    const scene::Scene scene = testing::simpleScene();
    for (const double offset : {1e5, 1e6}) {
        const auto far = testing::snapshot(testing::moved(scene, dvec3(offset, -offset, offset)));
        const TruthComparison sum = compareWithTruth(far, "shadow-volume-zfail", {}, {320, 240}, 0, kTiePx);
        EXPECT_GT(sum.shadowed, 500);
        EXPECT_LE(sum.wrong(), 2) << offset << ": " << sum; // 3e-5 of the pixels
    }
}

TEST_F(ZFailTest, MirroredAndScaledCasters) {
    scene::Scene scene = testing::floorScene();
    dmat4 mirror = testing::translation({-1, 1, 0});
    mirror[0][0] = -1.5;
    mirror[1][1] = 0.75;
    testing::addObject(scene, scene::makeTorus(0.75, 0.25, {24, 12}), mirror);
    testing::addObject(scene, scene::makeBox({1, 1, 1}), testing::translation({1.5, 0.5, 0.5}));
    scene.lights = {testing::pointLight({2, 5, 3}), testing::directionalLight({0.5, -1, 0.25})};
    for (const int light : {0, 1}) {
        const TruthComparison sum =
            compareWithTruth(testing::snapshot(scene), "shadow-volume-zfail", {}, {320, 240}, light, kTiePx);
        EXPECT_GT(sum.shadowed, 500);
        EXPECT_LE(sum.wrong(), 2) << sum;
    }
}

// Solids whose front faces alone are counted (outward_parts.h): mirrored, within each other, hollow, around the light.
TEST_F(ZFailTest, FrontFacesAloneCountLikeAll) {
    scene::Scene scene = testing::floorScene();
    dmat4 mirror = testing::translation({-1.5, 1, 0});
    mirror[0][0] = -1;
    testing::addObject(scene, scene::makeSphere(0.75, 24), mirror);
    testing::addObject(scene, scene::makeBox({1, 1, 1}), testing::translation({1, 0.5, 0.5}));
    testing::addObject(scene, scene::makeBox({1, 1, 1}), testing::translation({1.5, 0.75, 0.25}));
    testing::addObject(scene, scene::makeBox({0.25, 4, 0.25}), testing::translation({0, 0, -1})); // through the floor
    scene::Mesh hollow = scene::makeBox({1, 1, 1});
    for (std::size_t t = 0; t < 12; ++t) { // an inner wall, the other way round
        const uvec3 triangle = hollow.triangles[t];
        std::uint32_t added[3] = {triangle.x, triangle.z, triangle.y};
        for (std::uint32_t& v : added) {
            hollow.positionsMesh.push_back(0.75f * hollow.positionsMesh[v]);
            hollow.normalsMesh.push_back(-hollow.normalsMesh[v]);
            v = static_cast<std::uint32_t>(hollow.positionsMesh.size()) - 1;
        }
        hollow.triangles.emplace_back(added[0], added[1], added[2]);
    }
    hollow.parts[0].triangleCount = 24;
    testing::addObject(scene, hollow, testing::translation({-0.5, 0.5, 2}));
    scene.lights = {testing::pointLight({2, 5, 3}), testing::directionalLight({0.5, -1, 0.25}),
                    testing::pointLight({1, 0.625, 0.5}),    // within both boxes
                    testing::pointLight({-0.5, 0.5, 2.25})}; // in the hollow
    for (int light = 0; light < 4; ++light) {
        const TruthComparison sum =
            compareWithTruth(testing::snapshot(scene), "shadow-volume-zfail", {}, {320, 240}, light, kTiePx);
        EXPECT_GT(sum.lit, light < 2 ? 10000 : -1); // a light in a box lights nothing that is seen
        EXPECT_GT(sum.shadowed, 1500);
        EXPECT_LE(sum.wrong(), 2) << light << ": " << sum;
    }
}

TEST_F(ZFailTest, WhatReceivesNoShadowIsLitAndWhatCastsNoneBlocksNothing) {
    scene::Scene scene = testing::simpleScene();
    scene.objects[0].receivesShadow = false;
    scene.objects[1].castsShadow = false; // the box, which the plate above it shadows
    testing::addObject(scene, scene::makeQuad({1.5, 1.5}), testing::translation({-0.75, 1.75, 0.5}));
    const TruthComparison sum =
        compareWithTruth(testing::snapshot(scene), "shadow-volume-zfail", {}, {320, 240}, 0, kTiePx);
    EXPECT_GT(sum.lit, 20000);    // the floor
    EXPECT_GT(sum.shadowed, 500); // the box
    EXPECT_LE(sum.wrong(), 2) << sum;
}

} // namespace
} // namespace shadowlab
