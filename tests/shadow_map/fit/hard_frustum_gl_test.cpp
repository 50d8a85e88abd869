// Hard cases of the light's camera: what is beside its picture, before it, behind it, and far away.
//   M4 edge of the map       BesideTheMapAllIsLit; naive: border=edge
//      before the near plane CastersBeforeTheNearPlaneCount; naive: depth-clamp=false
//   M5 behind the light      BehindALightNothingIsMirrored; naive: reject-behind=false
//   M6 range of depths       AnyDepthFormatIsEnoughForFittedDepths; naive: depth-range=wide
//   M17 light in its caster  ALightInsideAnOpenBoxShinesOutOfItOnly; naive: depth-clamp=false
// SPDX-License-Identifier: MIT
#include <cmath>

#include "techniques/foundation/scene/model/shapes.h"
#include "tests/shadow_map/edge_reach.h"
#include "tests/support/gl_fixture.h"
#include "tests/support/scenes.h"

namespace shadowlab {
namespace {

using testing::JudgedPicture;
using testing::TruthComparison;
using HardFrustumTest = testing::GlTest;

constexpr ivec2 kSize{256, 192};
constexpr int kResolution = 1024;
// Of a single comparison the texel's centre is at most 0.71 texels away; the rest of 1.5 is what a bias may move the edge.
constexpr double kReachTexels = 1.5;

/// Excused is what is within a single comparison's reach of a true edge. `filter=hard`, so that nothing else is.
JudgedPicture judged(const scene::Scene& scene) {
    const auto snapshot = testing::snapshot(scene);
    return {snapshot, kSize, 0, testing::edgeReach(snapshot, 0, kResolution, kSize, kReachTexels)};
}

TruthComparison compare(const JudgedPicture& judged, std::vector<std::string> settings = {}) {
    settings.insert(settings.end(), {"filter=hard", "resolution=" + std::to_string(kResolution)});
    return judged.compare(testing::renderVisibility(judged.snapshot(), "shadow-map", settings, kSize, 0));
}

void expectRight(const TruthComparison& sum, const std::string& what = "") {
    std::cout << what << ": " << sum << "\n";
    EXPECT_GT(sum.lit, 500) << what;
    EXPECT_GT(sum.shadowed, 500) << what;
    EXPECT_EQ(sum.wrong(), 0) << what << ": " << sum;
    EXPECT_LT(sum.ties, sum.compared / 20) << what << ": edges everywhere, the test says nothing";
}

// M4. The map is as wide as the beam and its shadow, the floor is wider on all sides; the beam goes on beyond the picture,
// so that the map's border, which ends where the receivers in view do, cuts it.
scene::Scene beamOverFloor() {
    scene::Scene scene = testing::floorScene();
    scene.lights.push_back(testing::directionalLight({0.5, -1, 0.25}));
    testing::addObject(scene, scene::makeBox({40, 0.25, 0.5}), testing::translation({0, 1, 0}));
    return scene;
}

TEST_F(HardFrustumTest, BesideTheMapAllIsLit) {
    const JudgedPicture picture = judged(beamOverFloor());
    for (const char* fit : {"fit=view", "fit=scene"})
        expectRight(compare(picture, {fit}), fit);
    expectRight(compare(picture, {"cull=false"}), "with the floor in the map");
    // Around a few small casters the floor goes on beyond the map on all sides. To one side it is farther from the light than
    // what the outermost texels hold, which is floor, too.
    scene::Scene few = testing::simpleScene();
    few.lights = {testing::directionalLight({0.5, -1, 0.25})};
    const JudgedPicture small = judged(few);
    expectRight(compare(small, {"cull=false"}), "a map amid the floor");
    const TruthComparison edge = compare(small, {"border=edge", "cull=false"});
    std::cout << "border=edge: " << edge << "\n";
    EXPECT_GT(edge.falseShadow, 500);
}

// M4. The range of depths is that of the receivers; the ball is above all of them, between the map's near plane and the sun.
TEST_F(HardFrustumTest, CastersBeforeTheNearPlaneCount) {
    scene::Scene scene = testing::floorScene();
    scene.lights.push_back(testing::directionalLight({0.1, -1, 0.2}));
    testing::addObject(scene, scene::makeSphere(1, 64), testing::translation({0, 20, -4}));
    const JudgedPicture picture = judged(scene);
    expectRight(compare(picture), "clamped");
    EXPECT_GT(compare(picture, {"depth-clamp=false"}).falseLit, 500);
}

scene::Light spot(const dvec3& position, const dvec3& direction, double coneDegrees) {
    scene::Light light = testing::pointLight(position);
    light.name = "spot";
    light.type = scene::LightType::spot;
    light.directionWorld = glm::normalize(direction);
    light.coneDegrees = coneDegrees;
    return light;
}

/// A light at (0, 2, 0), a box before it on +x with a wall to shadow, and a wall behind it on -x.
scene::Scene wallBehind(const scene::Light& light) {
    scene::Scene scene = testing::floorScene();
    scene.lights.push_back(light);
    testing::addObject(scene, scene::makeBox({0.5, 0.5, 0.5}), testing::translation({1.5, 1.75, 0}));
    for (const double x : {-3.0, 4.0})
        // Only receives: one map that looks toward +x is enough.
        testing::addObject(scene, scene::makeBox({0.2, 4, 6}), testing::translation({x, 2, 0})).castsShadow = false;
    scene.camera.positionWorld = {0, 3, 7};
    scene.camera.targetWorld = {0.5, 1.5, 0};
    return scene;
}

TEST_F(HardFrustumTest, BehindALightNothingIsMirrored) {
    expectRight(compare(judged(wallBehind(spot({0, 2, 0}, {1, -0.5, 0}, 90)))), "spot");
    // Behind a spot it is dark anyway; a lamp whose casters are all to one side has one map, too, and shines to all sides.
    const JudgedPicture lamp = judged(wallBehind(testing::pointLight({0, 2, 0})));
    expectRight(compare(lamp), "lamp");
    EXPECT_GT(compare(lamp, {"reject-behind=false"}).falseShadow, 200);
}

/// With each format of depths: right, and what is wrong at pixels' centres the same but for one pixel in a thousand.
void expectSameWithAnyFormat(const JudgedPicture& picture) {
    std::vector<int> wrong;
    for (const std::string format : {"depth-format=16", "depth-format=24", "depth-format=32f"}) {
        const TruthComparison sum = compare(picture, {format});
        expectRight(sum, format);
        wrong.push_back(sum.ties + sum.wrong());
    }
    for (const int w : wrong)
        EXPECT_NEAR(w, wrong.back(), 1e-3 * kSize.x * kSize.y);
}

// M6. The lamp is 970 m away. In a range that begins at 0.01 m the last of 2^16 steps would be 900^2 / (0.01 * 65535) = 1236 m
// long. Floating point is no way out: near 1 its steps are 2^-24, as those of 24 bits, and still 5 m long.
TEST_F(HardFrustumTest, AnyDepthFormatIsEnoughForFittedDepths) {
    scene::Scene scene = testing::simpleScene();
    scene.lights = {testing::directionalLight({0.5, -1, 0.25})};
    expectSameWithAnyFormat(judged(scene));
    scene.lights = {testing::pointLight({700, 600, 300})};
    const JudgedPicture far = judged(scene);
    expectSameWithAnyFormat(far);
    for (const std::string format : {"depth-format=16", "depth-format=24", "depth-format=32f"}) {
        const TruthComparison wide = compare(far, {format, "depth-range=wide"});
        std::cout << format << ", depth-range=wide: " << wide << "\n";
        EXPECT_GT(wide.falseLit, wide.shadowed / 2) << wide;
    }
}

/// A square pot without a lid around the light, one of its walls as near to it as `distance`.
scene::Scene lightInPot(double distance) {
    scene::Scene scene = testing::floorScene();
    scene.lights.push_back(testing::pointLight({0, 1, 0}));
    const double x = distance, w = 0.5, low = 0.5, high = 1.25;
    const dvec3 corners[2][4] = {{{x, low, -w}, {x, low, w}, {x - 2 * w, low, w}, {x - 2 * w, low, -w}},
                                 {{x, high, -w}, {x, high, w}, {x - 2 * w, high, w}, {x - 2 * w, high, -w}}};
    std::vector<dvec3> triangles;
    const auto quad = [&](const dvec3& a, const dvec3& b, const dvec3& c, const dvec3& d) {
        for (const dvec3& corner : {a, b, c, a, c, d})
            triangles.push_back(corner);
    };
    quad(corners[0][0], corners[0][1], corners[0][2], corners[0][3]);
    for (int i = 0; i < 4; ++i)
        quad(corners[0][i], corners[0][(i + 1) % 4], corners[1][(i + 1) % 4], corners[1][i]);
    testing::addObject(scene, testing::triangleSoup(triangles));
    testing::addObject(scene, scene::makeBox({0.2, 4, 6}), testing::translation({-3, 2, 0}));
    testing::addObject(scene, scene::makeBox({0.2, 4, 6}), testing::translation({3, 2, 0}));
    scene.camera.positionWorld = {0, 3, 8};
    scene.camera.targetWorld = {0, 1.5, 0};
    return scene;
}

TEST_F(HardFrustumTest, ALightInsideAnOpenBoxShinesOutOfItOnly) {
    expectRight(compare(judged(lightInPot(0.5))), "in the middle");
    const JudgedPicture close = judged(lightInPot(0.003)); // nearer than any near plane of the maps
    expectRight(compare(close), "3 mm from a wall");
    EXPECT_GT(compare(close, {"depth-clamp=false"}).falseLit, 500);
}

} // namespace
} // namespace shadowlab
