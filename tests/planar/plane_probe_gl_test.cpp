// What the probe of planar shadows says covers a point, against the picture, and against the exact judge.
// SPDX-License-Identifier: MIT
#include <iostream>

#include "techniques/foundation/scene/model/shapes.h"
#include "techniques/foundation/trace/judge/exact_visibility.h"
#include "techniques/probed/plane_probe.h"
#include "tests/support/gl_fixture.h"
#include "tests/support/probed_picture.h"
#include "tests/support/scenes.h"

namespace shadowlab {
namespace {

using testing::ProbedPicture;
using PlaneProbeTest = testing::GlTest;

constexpr ivec2 kSize{96, 72};
constexpr int kStep = 2;

scene::Scene boxesOverFloor() {
    scene::Scene scene = testing::floorScene();
    testing::addObject(scene, scene::makeBox({1, 1, 1}), testing::translation({0, 0.5, 0}));
    testing::addObject(scene, scene::makeBox({0.5, 0.5, 0.5}), testing::translation({1.5, 1.5, 0.5}));
    testing::addObject(scene, scene::makeTorus(0.5, 0.2, {24, 12}), testing::translation({-1.5, 1, 0.5}));
    return scene;
}

TEST_F(PlaneProbeTest, DecidesAsThePictureDoesAndCountsAsTheJudgeDoes) {
    int compared = 0, shadowed = 0, covers = 0;
    // The last light stands between the casters: some are beyond it, and nothing of them is a shadow.
    for (const scene::Light& light : {testing::pointLight({2, 5, 3}), testing::directionalLight({0.5, -1, 0.25}),
                                      testing::pointLight({0.6, 1.2, 0.6})}) {
        scene::Scene scene = boxesOverFloor();
        scene.lights = {light};
        const auto snapshot = testing::snapshot(scene);
        const trace::ExactVisibility judge(snapshot);
        ProbedPicture picture(snapshot, "planar", {}, kSize);
        int differing = 0, here = 0;
        for (int y = 1; y < kSize.y; y += kStep)
            for (int x = 1; x < kSize.x; x += kStep) {
                const Probe probe = picture.probe(x, y);
                if (!probe.find<PlaneProbe>() || !probe.find<PlaneProbe>()->receives) continue;
                ++here;
                differing += (probe.decision->visibility > 0.5) != (picture.visibility().grey(x, y) > 127);
                const auto hit = judge.eyeHit(snapshot->camera, dvec2(x, y) + 0.5, kSize);
                int casting = 0;
                for (const PlaneProbe::Cover& cover : probe.find<PlaneProbe>()->covers) {
                    casting += cover.casts;
                    covers += 1;
                    const bool between = cover.height > 0 && cover.weight > 0;
                    EXPECT_TRUE(!cover.casts || between);
                    // What is clipped says why.
                    EXPECT_EQ(cover.casts, cover.why.empty());
                }
                shadowed += casting > 0;
                if (judge.visibility(*hit, snapshot->camera, 0) != trace::Visibility::turnedAway) {
                    EXPECT_EQ(casting, judge.crossings(*hit, 0)) << x << "," << y;
                }
            }
        compared += here;
        EXPECT_LE(differing, 1 + here / 200) << "pixels whose centre an edge of a shadow passes within 1/256";
    }
    std::cout << compared << " points, " << shadowed << " in shadow, " << covers << " triangles on their lines\n";
    EXPECT_GT(compared, 1000);
    EXPECT_GT(shadowed, 100);
    EXPECT_GT(covers, 500);
}

TEST_F(PlaneProbeTest, WithoutClippingItNamesTheAntiShadow) {
    scene::Scene scene = boxesOverFloor();
    scene.lights = {testing::pointLight({0.6, 1.2, 0.6})};
    ProbedPicture picture(testing::snapshot(scene), "planar", {"clip=false"}, kSize);
    int named = 0;
    for (int y = 1; y < kSize.y; y += kStep)
        for (int x = 1; x < kSize.x; x += kStep) {
            const Probe probe = picture.probe(x, y);
            named += probe.decision && probe.decision->why.find("anti-shadow") != std::string::npos;
        }
    EXPECT_GT(named, 3);
}

} // namespace
} // namespace shadowlab
