// What the probe of shadow volumes says it counts, against the stencil that the graphics card counted; and what it decides,
// against the picture.
// SPDX-License-Identifier: MIT
#include <cmath>
#include <iostream>

#include "techniques/foundation/scene/model/shapes.h"
#include "techniques/probed/volume_probe.h"
#include "tests/support/gl_fixture.h"
#include "tests/support/hard_scenes.h"
#include "tests/support/probed_picture.h"
#include "tests/support/scenes.h"

namespace shadowlab {
namespace {

using testing::ProbedPicture;
using VolumeProbeTest = testing::GlTest;

constexpr ivec2 kSize{96, 72};
constexpr int kStep = 5; ///< pixels between those that are asked; no divisor of the size, so that columns differ

struct Agreement {
    int compared = 0, notZero = 0, atEdges = 0, differing = 0, decisions = 0;
};

/// The stencil picture has -1 where the stencil holds 255.
int asPictured(int stencil) { return stencil > 127 ? stencil - 256 : stencil; }

/// At an edge of a volume face the rasteriser's rounding may put a pixel's centre on the other side: its neighbours differ then.
bool isAtEdge(const ProbedPicture& picture, int x, int y) {
    for (int dy = -1; dy <= 1; ++dy)
        for (int dx = -1; dx <= 1; ++dx) {
            const ivec2 at = glm::clamp(ivec2(x + dx, y + dy), ivec2(0), kSize - 1);
            if (picture.texel(at.x, at.y).r != picture.texel(x, y).r) return true;
        }
    return false;
}

Agreement compare(const scene::Snapshot& scene, const std::string& technique, std::vector<std::string> settings) {
    ProbedPicture picture(scene, technique, settings, kSize, "stencil");
    Agreement result;
    for (int y = 1; y < kSize.y; y += kStep)
        for (int x = 1; x < kSize.x; x += kStep) {
            const Probe probe = picture.probe(x, y);
            if (!probe.find<VolumeProbe>()) continue; // background
            ++result.compared;
            const int counted = static_cast<int>(std::lround(picture.texel(x, y).r));
            result.notZero += counted != 0;
            const bool same = asPictured(probe.find<VolumeProbe>()->stencil) == counted;
            const bool decidesAlike = (probe.decision->visibility > 0.5) == (picture.visibility().grey(x, y) > 127);
            if (same && decidesAlike) {
                ++result.decisions;
                continue;
            }
            ++(isAtEdge(picture, x, y) ? result.atEdges : result.differing);
        }
    return result;
}

/// Under half a percent: the share of pixels within the rasteriser's 1/256 pixel of an edge, of pictures in which no pixel is more
/// than a few from one.
void expectAgreement(const Agreement& one, const std::string& what) {
    EXPECT_EQ(one.differing, 0) << what;
    EXPECT_LE(one.atEdges, 1 + one.compared / 200) << what;
    EXPECT_GT(one.decisions, one.compared * 9 / 10) << what;
}

TEST_F(VolumeProbeTest, CountsWhatTheStencilCounts) {
    Agreement sum;
    const auto add = [&](const scene::Scene& scene, const std::string& what) {
        const auto snapshot = testing::snapshot(scene);
        for (const char* technique : {"shadow-volume-zfail", "shadow-volume-zpass", "shadow-volume"}) {
            const Agreement one = compare(snapshot, technique, {});
            expectAgreement(one, what + ", " + technique);
            sum.compared += one.compared;
            sum.notZero += one.notZero;
            sum.atEdges += one.atEdges;
        }
    };
    add(testing::simpleScene(), "simple scene");
    scene::Scene sun = testing::simpleScene();
    sun.lights = {testing::directionalLight({0.5, -1, 0.25})};
    add(sun, "sun");
    for (const testing::HardClass hardClass :
         {testing::HardClass::soup, testing::HardClass::torus, testing::HardClass::nonManifold})
        add(testing::hardScene(hardClass, 1, false), toText(hardClass));
    std::cout << sum.compared << " pixels, " << sum.notZero << " of them not zero, " << sum.atEdges << " at edges\n";
    EXPECT_GT(sum.compared, 1500);
    EXPECT_GT(sum.notZero, 200);
}

TEST_F(VolumeProbeTest, CountsWhereTheTeachingFaultsAre) {
    const auto scene = testing::snapshot(testing::simpleScene());
    scene::Scene inShadow = testing::floorScene(); // the eye stands in the shadow of a wide roof
    testing::addObject(inShadow, scene::makeBox({6, 0.2, 6}), testing::translation({0, 4, 5}));
    testing::addObject(inShadow, scene::makeBox({1, 1, 1}), testing::translation({0, 0.5, 0}));
    inShadow.lights = {testing::directionalLight({0, -1, 0.05})};
    const auto eyeInShadow = testing::snapshot(inShadow);
    // Two roofs above the eye, whose volumes end before anything that is in view begins.
    scene::Scene underRoofs = testing::floorScene();
    testing::addObject(underRoofs, scene::makeBox({3, 0.1, 3}), testing::translation({0, 2.5, 4.5}));
    testing::addObject(underRoofs, scene::makeQuad({2, 2}), testing::translation({0, 3.5, 4.2}));
    testing::addObject(underRoofs, scene::makeSphere(0.5, 24), testing::translation({0, 1.2, 0}));
    underRoofs.lights = {testing::directionalLight({0.2, -1, -0.1})};
    underRoofs.camera.positionWorld = {0, 1, 4};
    underRoofs.camera.targetWorld = {0, 0.3, 0};
    const auto roofs = testing::snapshot(underRoofs);
    const auto soup = testing::snapshot(testing::hardScene(testing::HardClass::soup, 1, false));
    struct Case {
        const scene::Snapshot& scene;
        const char* technique;
        std::vector<std::string> settings;
    };
    int compared = 0;
    for (const Case& one : {
             Case{scene, "shadow-volume-zfail", {"caps=false"}},
             Case{scene, "shadow-volume-zfail", {"far-plane=clip", "volume-end=infinity"}},
             Case{scene, "shadow-volume-zfail", {"volume-end=distance", "extrusion=0.7"}},
             Case{scene, "shadow-volume-zfail", {"stencil-bits=1"}},
             Case{scene, "shadow-volume-zfail", {"construction=lecture"}},
             Case{eyeInShadow, "shadow-volume-zfail", {"volume-end=infinity"}}, // all far vertices are one point
             Case{eyeInShadow, "shadow-volume-zpass", {}},
             Case{eyeInShadow, "shadow-volume-zpass", {"eye-correction=true"}},
             Case{eyeInShadow, "shadow-volume", {}},
             Case{roofs, "shadow-volume-zpass", {}},
             Case{roofs, "shadow-volume-zpass", {"eye-correction=true"}},
             Case{soup, "shadow-volume-zfail", {"wrap=false", "stencil-bits=2"}},
             Case{soup, "shadow-volume-zfail", {"wrap=false", "two-sided=false"}},
             Case{soup, "shadow-volume-zpass", {"wrap=false", "stencil-bits=2"}},
         }) {
        const Agreement agreement = compare(one.scene, one.technique, one.settings);
        expectAgreement(agreement,
                        std::string(one.technique) + " " + (one.settings.empty() ? "" : one.settings.front()));
        compared += agreement.compared;
    }
    EXPECT_GT(compared, 1000);
}

// From an eye in shadow the two sums differ by the volumes that it is in: the lecture's reason for z-fail.
TEST_F(VolumeProbeTest, FromAnEyeInShadowZPassIsWrongByTheVolumesItIsIn) {
    scene::Scene scene = testing::floorScene();
    testing::addObject(scene, scene::makeBox({6, 0.2, 6}), testing::translation({0, 4, 5}));
    scene.lights = {testing::directionalLight({0, -1, 0.05})};
    ProbedPicture picture(testing::snapshot(scene), "shadow-volume-zpass", {}, kSize);
    int compared = 0, wrong = 0;
    for (int y = 1; y < kSize.y; y += kStep)
        for (int x = 1; x < kSize.x; x += kStep) {
            const Probe probe = picture.probe(x, y);
            if (!probe.find<VolumeProbe>()) continue;
            ++compared;
            const VolumeProbe& v = *probe.find<VolumeProbe>();
            ASSERT_GT(v.eyeCount, 0);
            EXPECT_EQ(v.backsBeyond - v.frontsBeyond, v.eyeCount + v.frontsBefore - v.backsBefore) << x << "," << y;
            wrong += !probe.decision->why.empty();
            if (!probe.decision->why.empty()) {
                EXPECT_NE(probe.decision->why.find("the eye is in"), std::string::npos) << probe.decision->why;
            }
        }
    EXPECT_GT(compared, 100);
    EXPECT_GT(wrong, 50);
}

} // namespace
} // namespace shadowlab
