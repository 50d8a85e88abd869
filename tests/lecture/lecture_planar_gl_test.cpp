// The lecture's direct projection against the truth: exact on flat sides, and no shadow anywhere else.
// SPDX-License-Identifier: MIT
#include "techniques/foundation/scene/model/shapes.h"
#include "tests/support/gl_fixture.h"
#include "tests/support/scenes.h"
#include "tests/support/truth_comparison.h"

namespace shadowlab {
namespace {

using trace::Visibility;
using LecturePlanarTest = testing::GlTest;

constexpr ivec2 kSize{320, 240};

/// Pixels on flat objects, which are projection planes, and on all others.
struct Counts {
    int flatLit = 0, flatShadowed = 0, flatWrong = 0;
    int curvedLit = 0, curvedShadowed = 0, curvedDark = 0; ///< the last: lit or shadowed in truth, and drawn dark
};

/// `flat`: the objects that are. Pixels whose truth changes within the tie radius are not counted.
Counts countOf(const scene::Scene& scene, const std::vector<std::uint32_t>& flat, int light) {
    const scene::Snapshot snapshot = testing::snapshot(scene);
    const testing::JudgedPicture judged(snapshot, kSize, light, testing::kTiePx);
    const auto image = testing::renderVisibility(snapshot, "lecture-planar", {}, kSize, light);
    Counts counts;
    for (int y = 0; y < kSize.y; ++y)
        for (int x = 0; x < kSize.x; ++x) {
            const auto& hit = judged.hit(x, y);
            const Visibility truth = judged.truth(x, y);
            if (!hit || truth == Visibility::turnedAway) continue;
            const bool isLit = image.grey(x, y) > 127, shouldBeLit = truth == Visibility::lit;
            const bool isFlat = std::ranges::find(flat, hit->object) != flat.end();
            if (isFlat) {
                ++(shouldBeLit ? counts.flatLit : counts.flatShadowed);
                counts.flatWrong += isLit != shouldBeLit && !judged.isTie(x, y);
            } else {
                ++(shouldBeLit ? counts.curvedLit : counts.curvedShadowed);
                counts.curvedDark += !isLit && !judged.isTie(x, y);
            }
        }
    return counts;
}

TEST_F(LecturePlanarTest, ShadowsAreExactOnPlanesAndThereAreNoneOnCurvedSurfaces) {
    scene::Scene scene = testing::simpleScene(); // floor, box, sphere and torus
    testing::addObject(scene, scene::makeBox({0.8, 0.1, 0.8}),
                       testing::translation({0.4, 1.5, 1.15})); // shadows the sphere
    scene.lights.push_back(testing::directionalLight({0.5, -1, 0.25}));
    for (const int light : {0, 1}) {
        const Counts counts = countOf(scene, {0, 1, 4}, light); // floor and boxes
        EXPECT_GT(counts.flatLit, 10000);
        EXPECT_GT(counts.flatShadowed, 1000);
        // One pixel may lie where a caster touches the floor: its edge and that of its flattened image are one line, rounded twice.
        EXPECT_LE(counts.flatWrong, 1) << "light " << light;
        EXPECT_GT(counts.curvedLit, 1000);
        EXPECT_GT(counts.curvedShadowed, 100) << "else nothing is missing";
        EXPECT_EQ(counts.curvedDark, 0) << "light " << light;
    }
}

TEST_F(LecturePlanarTest, AShadowEndsWhereItsPlaneDoes) {
    scene::Scene scene = testing::floorScene();
    testing::addObject(scene, scene::makeQuad({2, 2}),
                       testing::translation({0, 1, 0})); // smaller than the shadow on it
    testing::addObject(scene, scene::makeBox({3, 0.2, 0.5}), testing::translation({0, 2, 0}));
    scene.lights.push_back(testing::pointLight({0.5, 5, 0.25}));
    const Counts counts = countOf(scene, {0, 1, 2}, 0);
    EXPECT_GT(counts.flatLit, 10000);
    EXPECT_GT(counts.flatShadowed, 2000);
    EXPECT_LE(counts.flatWrong, 1);
}

// Without the cut at the plane, what is below it would be projected up onto it.
TEST_F(LecturePlanarTest, WhatIsBelowThePlaneCastsNothingOnIt) {
    scene::Scene scene = testing::floorScene();
    testing::addObject(scene, scene::makeSphere(1, 32), testing::translation({0, 0.25, 0}));     // half sunk in
    testing::addObject(scene, scene::makeBox({1, 1, 1}), testing::translation({2, -2, 1}));      // below it
    testing::addObject(scene, scene::makeBox({0.5, 0.5, 0.5}), testing::translation({1, 7, 1})); // above the light
    scene.lights.push_back(testing::pointLight({3, 2, 2}));
    const Counts counts = countOf(scene, {0, 2, 3}, 0);
    EXPECT_GT(counts.flatLit, 10000);
    EXPECT_GT(counts.flatShadowed, 500);
    EXPECT_LE(counts.flatWrong, 1);
}

} // namespace
} // namespace shadowlab
