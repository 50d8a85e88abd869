// shadow-map-exact against the judge: no pixel is wrong outside ties, in scenes made to break shadow algorithms, with any
// projection. The same map without it is wrong in thousands.
// SPDX-License-Identifier: MIT
#include "app/context/assets.h"
#include "app/judge/verdict.h"
#include "app/picture/session.h"
#include "techniques/foundation/scene/json/scene_json.h"
#include "techniques/foundation/scene/load/load.h"
#include "techniques/foundation/scene/model/shapes.h"
#include "tests/support/gl_fixture.h"
#include "tests/support/hard_scenes.h"
#include "tests/support/scenes.h"
#include "tests/support/truth_comparison.h"

namespace shadowlab {
namespace {

using testing::compareWithTruth;
using testing::TruthComparison;
using ExactMapTest = testing::GlTest;

constexpr ivec2 kSize{192, 144};

/// Wrong pixels of the exact map, and of the shadow map with the same settings.
struct Both {
    TruthComparison exact, plain;
};

void compare(const scene::Scene& scene, const std::vector<std::string>& settings, Both& both, ivec2 size = kSize) {
    const auto snapshot = testing::snapshot(scene);
    for (int light = 0; light < static_cast<int>(scene.lights.size()); ++light) {
        both.exact += compareWithTruth(snapshot, "shadow-map-exact", settings, size, light, testing::kTiePx);
        both.plain += compareWithTruth(snapshot, "shadow-map", settings, size, light, testing::kTiePx);
    }
}

void expectExact(const Both& both, const std::string& what) {
    std::cout << what << ": exact " << both.exact << "; plain " << both.plain << "\n";
    EXPECT_GT(both.exact.lit, 400) << what; // inside a closed tube nothing is, but for some holes
    EXPECT_GT(both.exact.shadowed, 500) << what;
    EXPECT_EQ(both.exact.wrong(), 0) << what << ": " << both.exact;
}

TEST_F(ExactMapTest, HardScenesOfEveryClass) {
    const unsigned scenes = std::getenv("SHADOWLAB_LONG") ? 100 : 5;
    int plainWrong = 0;
    for (const testing::HardClass hardClass : testing::kHardClasses) {
        Both both;
        for (unsigned number = 0; number < scenes; ++number)
            for (const bool directional : {false, true}) {
                const int before = both.exact.wrong();
                compare(testing::hardScene(hardClass, number, directional), {"resolution=256"}, both);
                EXPECT_EQ(both.exact.wrong(), before)
                    << toText(hardClass) << " " << number << (directional ? ", sun" : "");
            }
        expectExact(both, testing::toText(hardClass));
        plainWrong += both.plain.wrong();
    }
    EXPECT_GT(plainWrong, 3000) << "the scenes are easy: the test says nothing";
}

TEST_F(ExactMapTest, EveryProjectionResolutionAndFormat) {
    scene::Scene scene = testing::simpleScene();
    scene.lights.push_back(testing::directionalLight({0.5, -1, 0.25}));
    scene.lights.push_back(testing::pointLight({0, 1.2, 0.1})); // among the casters: six maps
    for (const std::vector<std::string>& settings :
         std::vector<std::vector<std::string>>{{"resolution=64"},
                                               {"resolution=1024"},
                                               {"resolution=4096"},
                                               {"resolution=512", "depth-format=16"},
                                               {"resolution=512", "depth-format=32f"},
                                               {"resolution=512", "fit=scene"},
                                               {"resolution=512", "cascades=4"},
                                               {"resolution=512", "cascades=3", "stable=false"},
                                               {"resolution=512", "warp=lispsm"},
                                               {"resolution=512", "warp=lispsm", "cascades=2"},
                                               {"resolution=512", "cull=false"}}) {
        Both both;
        compare(scene, settings, both);
        std::string what;
        for (const std::string& setting : settings)
            what += setting + " ";
        expectExact(both, what);
    }
}

/// A sheet that stands in another, and a box half sunk into a ball: surfaces pass through each other where neither has an
/// edge.
TEST_F(ExactMapTest, SurfacesThatPassThroughEachOther) {
    scene::Scene scene = testing::floorScene();
    scene.lights = {testing::pointLight({2, 4, 1.5}), testing::directionalLight({0.4, -1, -0.3})};
    testing::addObject(scene, scene::makeBox({3, 0.5, 3}), testing::translation({0, 0.25, 0}));
    const auto upright = [](const dvec3& at, double degrees) {
        return scene::worldFromObjectOf(dvec3(1), {90, degrees, 0}, at);
    };
    testing::addObject(scene, scene::makeQuad({1.2, 1}), upright({0.4, 0.6, 0.2}, 20));
    testing::addObject(scene, scene::makeQuad({1, 1.2}), upright({-0.6, 0.7, 0.3}, -35));
    testing::addObject(scene, scene::makeSphere(0.4, 32), testing::translation({0.2, 0.5, -0.8}));
    testing::addObject(scene, scene::makeBox({0.5, 0.5, 0.5}), testing::translation({-0.7, 0.6, -0.7}));
    Both both;
    for (const char* resolution : {"resolution=64", "resolution=128", "resolution=512"})
        compare(scene, {resolution}, both, {320, 240});
    expectExact(both, "passing through");
}

/// Boxes with faces in one plane, which pass the light's height far aside: in the map above the light their corners are
/// thousands of texels away, and float is coarse there. All that is seen is lit.
TEST_F(ExactMapTest, FacesThatShareAPlaneAndReachPastTheLight) {
    scene::Scene scene = testing::floorScene();
    scene.objects.clear();
    testing::addObject(scene, scene::makeBox({50, 50, 50}), testing::translation({100, 50, -200}));
    testing::addObject(scene, scene::makeBox({50, 200, 100}), testing::translation({-181.2, 192.7, 4.1}));
    testing::addObject(scene, scene::makeBox({50, 200, 100}), testing::translation({-181.2, 242.7, 4.1}));
    scene.lights = {testing::pointLight({-92.9, 91.4, -97.2})};
    scene.camera.positionWorld = {245.5, -44.9, 80.9};
    scene.camera.targetWorld = {-81.8, 7.5, 24.5};
    scene.camera.fovYDegrees = 90;
    scene.camera.near = 10;
    Both both;
    for (const char* resolution : {"resolution=1024", "resolution=2048"})
        compare(scene, {resolution}, both, {320, 240});
    std::cout << both.exact << "\n";
    EXPECT_GT(both.exact.lit, 5000);
    EXPECT_EQ(both.exact.wrong(), 0);
}

TEST_F(ExactMapTest, WhatIsSeenButCastsNoShadowAndWhatReceivesNone) {
    scene::Scene scene = testing::simpleScene();
    scene.objects[1].castsShadow = false;
    scene.objects[2].receivesShadow = false;
    Both both;
    compare(scene, {"resolution=256"}, both, {320, 240});
    expectExact(both, "no caster, no receiver");
}

// Where maps of all lights would be too large, lights share one. Of two in one place the second finds it as it needs it, and does not
// draw it again: what else it asks of its edges has to be found all the same.
TEST_F(ExactMapTest, LightsInOnePlaceThatShareAMap) {
    scene::Scene scene = testing::simpleScene();
    scene.lights.assign(5, scene.lights[0]); // 5 maps of 4096 x 4096: beyond what is kept for each
    const TruthComparison last =
        compareWithTruth(testing::snapshot(scene), "shadow-map-exact", {"resolution=4096"}, kSize, 4, testing::kTiePx);
    EXPECT_GT(last.lit, 5'000);
    EXPECT_GT(last.shadowed, 400);
    EXPECT_EQ(last.wrong(), 0) << last;
}

TEST_F(ExactMapTest, FarFromTheOrigin) {
    Both both;
    compare(testing::moved(testing::simpleScene(), dvec3(1e6, -1e6, 1e6)), {"resolution=512"}, both, {320, 240});
    expectExact(both, "at 1e6");
}

/// Judged as `measure` judges, by what the rasteriser shows, too: where two leaves that share an edge lie behind one another, it
/// may show the other one a thousandth of a pixel beyond that edge, and nothing on this side of it tells.
judge::Counts measuredErrors(picture::Session& session, const std::string& technique, ivec2 size, int light) {
    picture::Slot slot = picture::Session::makeSlot(technique);
    View view;
    view.camera = session.snapshot()->camera;
    view.size = size;
    FrameRequest request;
    request.stages = {{"visibility", light}};
    const picture::RenderedFrame frame = session.render(slot, view, request);
    const picture::VisibilityImage image = picture::readVisibility(picture::findStage(frame, {"visibility", light}));
    return judge::judge(session.truth(view, session.truthFor(slot, light)), image.greyAlpha).counts;
}

TEST_F(ExactMapTest, EveryBuiltInScene) {
    const auto root = context::assetsRoot();
    const ivec2 size = std::getenv("SHADOWLAB_LONG") ? ivec2(1280, 720) : ivec2(320, 180);
    int scenes = 0, plainWrong = 0;
    for (const std::string& name : scene::builtInScenes(root)) {
        picture::Session session(scene::loadScene(name, {.assetsRoot = root, .allowed = {}, .limits = {}}));
        int lit = 0, shadowed = 0, ties = 0;
        for (int light = 0; light < static_cast<int>(session.snapshot()->lights.size()); ++light) {
            const judge::Counts exact = measuredErrors(session, "shadow-map-exact", size, light);
            EXPECT_EQ(exact.wrong() + exact.stray, 0) << name << ", light " << light;
            lit += exact.lit, shadowed += exact.shadowed, ties += exact.ties;
            plainWrong += measuredErrors(session, "shadow-map", size, light).wrong();
        }
        EXPECT_GT(lit, 400) << name;
        EXPECT_GT(shadowed, 500) << name;
        EXPECT_LT(ties, (lit + shadowed) / 50) << name << ": what is excused is rare"; // 1.3 % among columns
        ++scenes;
    }
    EXPECT_GE(scenes, 9);
    EXPECT_GT(plainWrong, 300) << "the scenes are easy: the test says nothing";
}

} // namespace
} // namespace shadowlab
