// Planar shadows against the exact judge: on the planes that receive they must be exact, wherever light, casters and eye
// are; and each naive variant must fail where it is known to.
// SPDX-License-Identifier: MIT
#include "techniques/foundation/scene/depth_fit.h"
#include "techniques/foundation/scene/shapes.h"
#include "techniques/planar/receivers.h"
#include "tests/support/gl_fixture.h"
#include "tests/support/hard_scenes.h"
#include "tests/support/scenes.h"
#include "tests/support/truth_comparison.h"

namespace shadowlab {
namespace {

using testing::HardClass;
using PlanarTest = testing::GlTest;

constexpr ivec2 kSize{320, 240};

/// Pixels on receiver planes, held against the truth.
struct OnPlanes {
    int lit = 0, shadowed = 0, falseLit = 0, falseShadow = 0, ties = 0;
    int elsewhere = 0;         ///< pixels on surfaces that receive nothing
    int elsewhereShadowed = 0; ///< those of them that face the light and were drawn dark all the same
    [[nodiscard]] int wrong() const { return falseLit + falseShadow; }
    OnPlanes& operator+=(const OnPlanes& o) {
        lit += o.lit, shadowed += o.shadowed, falseLit += o.falseLit, falseShadow += o.falseShadow, ties += o.ties;
        elsewhere += o.elsewhere, elsewhereShadowed += o.elsewhereShadowed;
        return *this;
    }
};
std::ostream& operator<<(std::ostream& stream, const OnPlanes& c) {
    return stream << c.lit << " lit, " << c.shadowed << " shadowed, " << c.falseLit << " false lit, " << c.falseShadow
                  << " false shadow, " << c.ties << " ties, " << c.elsewhere << " elsewhere, " << c.elsewhereShadowed
                  << " of them dark";
}

/// The truth at the sixteen directions on four circles within the tie radius.
bool isTie(const trace::ExactVisibility& judge, const scene::Camera& camera, dvec2 centre, int light,
           trace::Visibility truth) {
    for (int ring = 1; ring <= 4; ++ring)
        for (int i = 0; i < 16; ++i) {
            const double angle = 2 * M_PI * i / 16, radius = testing::kTiePx * ring / 4;
            const dvec2 there = centre + radius * dvec2(std::cos(angle), std::sin(angle));
            if (judge.at(camera, there, kSize, light) != truth) return true;
        }
    return false;
}

OnPlanes compare(const scene::Scene& scene, const std::vector<std::string>& settings = {}, int light = 0) {
    const scene::Snapshot snapshot = testing::snapshot(scene);
    const session::VisibilityImage image = testing::renderVisibility(snapshot, "planar", settings, kSize, light);
    planar::Receivers receivers;
    while (!receivers.findNext(snapshot)) {
    }
    const double aspect = static_cast<double>(kSize.x) / kSize.y;
    const scene::Camera camera = scene::withTightNear(scene.camera, scene, scene::objectBounds(scene), aspect);
    const auto chosen = receivers.choose(scene, gl::eyeMatrices(camera, kSize), planar::kMostReceivers);
    const trace::ExactVisibility judge(snapshot);
    OnPlanes result;
    for (int y = 0; y < kSize.y; ++y)
        for (int x = 0; x < kSize.x; ++x) {
            const dvec2 centre(x + 0.5, y + 0.5);
            const auto hit = judge.eyeHit(scene.camera, centre, kSize);
            if (!hit) continue;
            const bool onPlane = std::ranges::any_of(chosen, [&](const planar::ChosenReceiver& one) {
                return one.receiver.object == hit->object && planar::contains(one.receiver.face->runs, hit->triangle);
            });
            const trace::Visibility truth = judge.visibility(*hit, scene.camera, light);
            const bool lit = image.grey(x, y) > 127;
            if (!onPlane) {
                ++result.elsewhere;
                const bool gateOpen = truth == trace::Visibility::lit || truth == trace::Visibility::shadowed;
                if (gateOpen && !lit && !isTie(judge, scene.camera, centre, light, truth)) ++result.elsewhereShadowed;
                continue;
            }
            result.lit += truth == trace::Visibility::lit;
            result.shadowed += truth == trace::Visibility::shadowed;
            if (lit == (truth == trace::Visibility::lit)) continue;
            if (isTie(judge, scene.camera, centre, light, truth))
                ++result.ties;
            else
                ++(lit ? result.falseLit : result.falseShadow);
        }
    return result;
}

/// Zero wrong pixels, of enough that are lit and in shadow.
void expectExact(const scene::Scene& scene, int least = 500, int light = 0) {
    const OnPlanes sum = compare(scene, {}, light);
    EXPECT_GE(sum.lit, least) << sum;
    EXPECT_GE(sum.shadowed, least) << sum;
    EXPECT_EQ(sum.wrong(), 0) << sum;
    EXPECT_EQ(sum.elsewhereShadowed, 0) << sum;
}

scene::Object& addBox(scene::Scene& scene, const dvec3& size, const dvec3& middle) {
    return testing::addObject(scene, scene::makeBox(size), testing::translation(middle));
}

/// Floor, camera and light, and nothing that casts.
scene::Scene floorUnder(const dvec3& lightWorld) {
    scene::Scene scene = testing::floorScene();
    scene.lights.push_back(testing::pointLight(lightWorld));
    return scene;
}

TEST_F(PlanarTest, ASimpleSceneUnderAPointLightAndTheSun) {
    scene::Scene scene = testing::simpleScene();
    scene.lights.push_back(testing::directionalLight({0.5, -1, 0.25}));
    expectExact(scene);
    expectExact(scene, 500, 1);
    const OnPlanes sum = compare(scene);
    EXPECT_GT(sum.elsewhere, 1000) << "ball and torus are there, and receive nothing";
}

TEST_F(PlanarTest, EveryHardClassIsExactOnItsPlanes) {
    // The floor, and each loose triangle that is large enough: twenty planes through one another.
    const int scenes = std::getenv("SHADOWLAB_LONG") ? 60 : 3;
    OnPlanes all;
    for (const bool directional : {false, true})
        for (const HardClass hardClass : testing::kHardClasses) {
            OnPlanes sum;
            for (int i = 0; i < scenes; ++i)
                sum += compare(testing::hardScene(hardClass, static_cast<unsigned>(i), directional));
            std::cout << toText(hardClass) << (directional ? ", directional: " : ", point: ") << sum << "\n";
            EXPECT_GT(sum.lit, 100);
            EXPECT_GT(sum.shadowed, 500);
            all += sum;
        }
    // Isolated pixels where two triangles of the soup pass through each other, closer together than steps of depth: there
    // the rasteriser may see another one than the ray. Half a pixel in a million.
    EXPECT_LE(all.wrong(), 1e-6 * (all.lit + all.shadowed)) << all;
}

// What lies above the light casts nothing on the floor; flattened all the same, it is an anti-shadow.
TEST_F(PlanarTest, ACasterBeyondTheLight) {
    scene::Scene scene = floorUnder({0, 2, 0});
    addBox(scene, {1, 1, 1}, {0, 3.5, 0});
    addBox(scene, {0.8, 1, 0.8}, {1.5, 0.5, 0});
    expectExact(scene);
    EXPECT_GT(compare(scene, {"clip=false"}).falseShadow, 500);
}

TEST_F(PlanarTest, ACasterThatReachesAboveTheLight) {
    scene::Scene scene = floorUnder({1, 2, 0});
    addBox(scene, {0.5, 2, 0.5}, {0, 2, 0});
    expectExact(scene);
    EXPECT_GT(compare(scene, {"clip=false"}).wrong(), 500);
}

TEST_F(PlanarTest, VerticesExactlyAtTheHeightOfTheLight) {
    scene::Scene scene = floorUnder({1, 2, 0});
    addBox(scene, {0.5, 2, 0.5}, {0, 1, 0}); // its top is at 2
    expectExact(scene);
    scene = floorUnder({0, 4, 0});
    addBox(scene, {0.25, 3.999, 0.25}, {1, 1.9995, 0}); // its upper edge casts its shadow 4 km away
    expectExact(scene);
}

TEST_F(PlanarTest, ACasterThatReachesBelowThePlane) {
    scene::Scene scene = floorUnder({0, 4, 0});
    testing::addObject(scene, scene::makeBox({2, 1.5, 2}), testing::translation({0.5, -0.25, 0.5}));
    addBox(scene, {4, 0.5, 4}, {0, -1.5, 0}); // all of it
    scene.camera.positionWorld = {2, 4, 4};
    const OnPlanes clipped = compare(scene);
    EXPECT_GT(clipped.lit, 500);
    EXPECT_EQ(clipped.wrong(), 0) << clipped;
    EXPECT_GT(compare(scene, {"clip=false"}).falseShadow, 500);
}

TEST_F(PlanarTest, TheLightInThePlaneOrBehindIt) {
    for (const double height : {0.0, -2.0}) {
        scene::Scene scene = floorUnder({2, height, 3});
        addBox(scene, {1, 1, 1}, {0, 1, 0});
        addBox(scene, {0.2, 0.2, 0.2}, {1, 0.5, 1.75}); // shadows the box, unless the floor does
        const OnPlanes sum = compare(scene);
        EXPECT_GT(sum.lit + sum.shadowed, 200) << sum; // sides of the boxes
        EXPECT_EQ(sum.wrong(), 0) << sum;
    }
}

// A table and the floor below: what misses the table falls on the floor, at a place of its own.
TEST_F(PlanarTest, AShadowEndsWhereItsPlaneEnds) {
    scene::Scene scene = floorUnder({1, 4, 0.5});
    testing::addObject(scene, scene::makeQuad({2, 1}), testing::translation({0, 1, 0}));
    addBox(scene, {0.5, 0.5, 0.5}, {0.9, 1.5, 0});
    scene.camera.positionWorld = {-1.5, 3, 4};
    expectExact(scene);
    EXPECT_GT(compare(scene, {"stencil=false"}).falseShadow, 50) << "spilled over the edge of the table";
    EXPECT_GT(compare(scene, {"stencil=false", "offset=0"}).falseLit, 20) << "fights with the plane for depth";
}

TEST_F(PlanarTest, ACornerOfARoomWithEachLightType) {
    scene::Scene scene = floorUnder({2, 4, 2});
    const dmat4 turnX = glm::dmat4(dvec4(1, 0, 0, 0), dvec4(0, 0, 1, 0), dvec4(0, -1, 0, 0), dvec4(0, 2, -3, 1));
    const dmat4 turnZ = glm::dmat4(dvec4(0, -1, 0, 0), dvec4(1, 0, 0, 0), dvec4(0, 0, 1, 0), dvec4(-3, 2, 0, 1));
    testing::addObject(scene, scene::makeQuad({10, 4}), turnX);
    testing::addObject(scene, scene::makeQuad({4, 10}), turnZ);
    addBox(scene, {1, 2.5, 1}, {-1.5, 1.25, -1.5});
    using enum scene::LightType;
    for (const scene::LightType type : {point, directional, spot, rect, scene::LightType::sphere}) {
        scene.lights[0].type = type;
        scene.lights[0].directionWorld = glm::normalize(dvec3(-1, -1.2, -1));
        expectExact(scene);
    }
}

TEST_F(PlanarTest, MirroredTurnedAndScaledPlanesAndCasters) {
    scene::Scene scene = floorUnder({2, 5, 3});
    dmat4 mirror = testing::translation({-1, 1.2, 0});
    mirror[0] = dvec4(-1.5, 0.3, 0.2, 0);
    mirror[1] = dvec4(0.2, 0.75, 0.1, 0);
    testing::addObject(scene, scene::makeBox({1, 1, 1}), mirror);
    testing::addObject(scene, scene::makeTorus(0.75, 0.25, {24, 12}), testing::translation({1.5, 1.5, 0.5}));
    expectExact(scene);
}

TEST_F(PlanarTest, MovedFarFromTheOrigin) {
    const scene::Scene scene = testing::simpleScene();
    for (const double offset : {1e5, 1e6})
        expectExact(testing::moved(scene, dvec3(offset, -offset, offset)));
}

TEST_F(PlanarTest, FarAwayAndAtAGrazingAngleThereIsNoFightForDepth) {
    for (const double distance : {5.0, 50.0, 500.0}) {
        scene::Scene scene = floorUnder({0.5 * distance, distance, 0});
        scene.objects.clear();
        testing::addObject(scene, scene::makeQuad({20 * distance, 20 * distance}));
        addBox(scene, distance * dvec3(0.2, 0.2, 0.2), {0, 0.12 * distance, 0});
        scene.camera.positionWorld = {0, 0.1 * distance, distance};
        scene.camera.fovYDegrees = 30;
        expectExact(scene, 100);
    }
}

TEST_F(PlanarTest, WhatReceivesNoShadowIsLitAndWhatCastsNoneBlocksNothing) {
    scene::Scene scene = testing::simpleScene();
    scene.objects[0].receivesShadow = false;
    scene.objects[1].castsShadow = false;
    testing::addObject(scene, scene::makeQuad({1.5, 1.5}), testing::translation({-0.75, 1.75, 0.5}));
    const OnPlanes sum = compare(scene);
    EXPECT_GT(sum.shadowed, 200) << sum; // on the box
    EXPECT_GT(sum.elsewhere, 20000) << sum;
    EXPECT_EQ(sum.wrong() + sum.elsewhereShadowed, 0) << sum;
}

TEST_F(PlanarTest, TheLimitKeepsTheLargestPlanes) {
    const scene::Scene scene = testing::simpleScene();
    EXPECT_EQ(compare(scene, {"receivers=1"}).falseShadow, 0);
    EXPECT_GT(compare(scene, {"receivers=0"}).falseLit, 500) << "no plane, no shadow";
    EXPECT_LT(compare(scene, {"receivers=1"}).falseLit, 200) << "the floor is the largest, and has most of the shadow";
}

} // namespace
} // namespace shadowlab
