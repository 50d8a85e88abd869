// Ray tracing against the exact judge, which tries every triangle and shares no code with it: outside ties not one
// pixel may differ. And its picture against that of shadow volumes, which are drawn in quite another way.
// SPDX-License-Identifier: MIT
#include <cstdlib>

#include "app/picture/picture.h"
#include "techniques/foundation/scene/load/load.h"
#include "techniques/foundation/scene/model/shapes.h"
#include "techniques/foundation/trace/parallel.h"
#include "tests/support/gl_fixture.h"
#include "tests/support/hard_scenes.h"
#include "tests/support/scenes.h"
#include "tests/support/truth_comparison.h"

namespace shadowlab {
namespace {

using testing::compareWithTruth;
using testing::HardClass;
using testing::kTiePx;
using testing::TruthComparison;
using RayTracedTest = testing::GlTest;

TruthComparison compare(const scene::Scene& scene, ivec2 size, int light = 0) {
    return compareWithTruth(testing::snapshot(scene), "ray-traced", {}, size, light, kTiePx);
}

TEST_F(RayTracedTest, EveryHardClassIsExact) {
    TruthComparison all;
    const int scenes = std::getenv("SHADOWLAB_LONG") ? 200 : 12;
    for (const bool directional : {false, true})
        for (const HardClass hardClass : testing::kHardClasses) {
            TruthComparison sum;
            for (int i = 0; i < scenes; ++i)
                sum += compare(testing::hardScene(hardClass, static_cast<unsigned>(i), directional), {160, 120});
            std::cout << toText(hardClass) << (directional ? ", directional: " : ", point: ") << sum << "\n";
            EXPECT_GT(sum.lit, hardClass == HardClass::lightInMesh ? 100 : 500);
            EXPECT_GT(sum.shadowed, 500);
            EXPECT_EQ(sum.wrong(), 0) << toText(hardClass);
            all += sum;
        }
    EXPECT_LT(all.ties, all.compared / 10'000) << all; // what is excused must be rare
}

TEST_F(RayTracedTest, SimpleSceneOfEveryKindOfLight) {
    using enum scene::LightType;
    for (const scene::LightType type : {point, directional, spot, rect, sphere})
        for (const double offset : {0.0, 1e6}) {
            scene::Scene scene = testing::simpleScene();
            scene.lights[0].type = type;
            scene.lights[0].directionWorld = glm::normalize(dvec3(-0.4, -1, -0.6));
            scene.lights[0].coneDegrees = 50;
            scene.lights[0].edgeVWorld = {0, 0.3, 1};
            const TruthComparison sum = compare(testing::moved(scene, dvec3(offset, -offset, offset)), {320, 240});
            std::cout << scene::toText(type) << " at " << offset << ": " << sum << "\n";
            EXPECT_GT(sum.lit, 500);
            EXPECT_GT(sum.shadowed, 500);
            EXPECT_EQ(sum.wrong(), 0);
        }
}

TEST_F(RayTracedTest, MirroredAndScaledAndWhatCastsOrReceivesNone) {
    scene::Scene scene = testing::floorScene();
    dmat4 mirror = testing::translation({-1, 1, 0});
    mirror[0][0] = -1.5;
    mirror[1][1] = 0.75;
    testing::addObject(scene, scene::makeTorus(0.75, 0.25, {24, 12}), mirror);
    testing::addObject(scene, scene::makeBox({1, 1, 1}), testing::translation({1.5, 0.5, 0.5}));
    testing::addObject(scene, scene::makeQuad({1.5, 1.5}), testing::translation({1, 1.75, 0.5}));
    scene.objects[2].castsShadow = false;
    scene.objects[3].receivesShadow = false;
    scene.lights = {testing::pointLight({2, 5, 3}), testing::directionalLight({0.5, -1, 0.25})};
    for (const int light : {0, 1}) {
        const TruthComparison sum = compare(scene, {240, 180}, light);
        EXPECT_GT(sum.lit, 500);
        EXPECT_GT(sum.shadowed, 500);
        EXPECT_EQ(sum.wrong(), 0) << sum;
    }
}

// Two boxes that share a face, and thinner and thinner walls: no light may come through the crack or the wall.
TEST_F(RayTracedTest, NoLightLeaksThroughContactsAndThinWalls) {
    for (const double thickness : {1e-6, 1e-3, 1.0}) {
        scene::Scene scene = testing::floorScene();
        testing::addObject(scene, scene::makeBox({2, 2, thickness}), testing::translation({-1, 1, 0}));
        testing::addObject(scene, scene::makeBox({2, 2, thickness}), testing::translation({1, 1, 0}));
        scene.camera.positionWorld = {0.3, 1.5, 5};
        scene.camera.targetWorld = {0, 0.2, 0.5 * thickness + 0.2};
        scene.lights.push_back(testing::pointLight({0, 1, -4})); // behind the wall, opposite the crack
        const TruthComparison sum = compare(scene, {240, 180});
        EXPECT_GT(sum.shadowed, 500);
        EXPECT_EQ(sum.wrong(), 0) << thickness << ": " << sum;
    }
}

picture::RenderedFrame render(picture::Session& session, picture::Slot& slot, ivec2 size,
                              const std::vector<StageKey>& stages = {}) {
    View view;
    view.camera = session.snapshot()->camera;
    view.size = size;
    FrameRequest request;
    request.stages = stages;
    return session.render(slot, view, request);
}

scene::Scene shinyScene() {
    scene::Scene scene = testing::simpleScene();
    scene.materials[0].specular = vec3(0.3f);
    scene.lights[0].intensity = 25;
    scene.lights.push_back(testing::directionalLight({0.5, -1, 0.25}));
    scene.lights.back().intensity = 0.6;
    scene.lights.push_back(testing::pointLight({-1.5, 3, 0}));
    scene.lights.back().type = scene::LightType::rect;
    scene.lights.back().edgeUWorld = {0.5, 0, 0};
    scene.lights.back().edgeVWorld = {0, 0.1, 0.5}; // it shines down; its surface is seen from below and bright
    scene.lights.back().intensity = 4;
    scene.lights.push_back(scene.lights.back());
    scene.lights.back().name = "lid";
    scene.lights.back().positionWorld = {1.5, 0.5, 2}; // seen from above: dark
    scene::addEmitterSurfaces(scene);
    return scene;
}

// Both shade with the same formula; what may differ is where a silhouette or the edge of a shadow passes the centre of
// a pixel, and rounding: sums in half floats here and there, hence 1/255.
TEST_F(RayTracedTest, PictureEqualsThatOfShadowVolumes) {
    scene::Scene scene = shinyScene();
    const ivec2 size{320, 240};
    for (const double offset : {0.0, 1e5}) {
        const auto snapshot = testing::snapshot(testing::moved(scene, dvec3(offset, 0, -offset)));
        picture::Session session(snapshot);
        picture::Slot traced = picture::Session::makeSlot("ray-traced");
        picture::Slot volumes = picture::Session::makeSlot("shadow-volume-zfail");
        render(session, traced, size);
        render(session, volumes, size);
        const image::Image a = picture::PictureEncoder().encode(traced.target.color, 1.0f);
        const image::Image b = picture::PictureEncoder().encode(volumes.target.color, 1.0f);
        const trace::ExactVisibility judge(snapshot);
        const auto edgeNear = [&](int x, int y) { // does anything change within a 64th of a pixel?
            const auto at = [&](dvec2 p) {
                std::vector<int> seen;
                const auto hit = judge.eyeHit(snapshot->camera, p, size);
                seen.push_back(hit ? static_cast<int>(hit->object * 100'000 + hit->triangle) : -1);
                for (int light = 0; hit && light < static_cast<int>(scene.lights.size()); ++light)
                    seen.push_back(static_cast<int>(judge.visibility(*hit, snapshot->camera, light)));
                return seen;
            };
            const dvec2 centre(x + 0.5, y + 0.5);
            const auto here = at(centre);
            for (int i = 0; i < 16; ++i)
                if (at(centre + kTiePx * dvec2(std::cos(M_PI * i / 8), std::sin(M_PI * i / 8))) != here) return true;
            return false;
        };
        int different = 0, excused = 0, bright = 0, largest = 0;
        for (int y = 0; y < size.y; ++y)
            for (int x = 0; x < size.x; ++x) {
                int most = 0;
                for (std::size_t c = 0; c < 4; ++c) {
                    const std::size_t i = 4 * (static_cast<std::size_t>(y) * 320 + static_cast<std::size_t>(x)) + c;
                    most = std::max(most, std::abs(a.rgba[i] - b.rgba[i]));
                    bright += c == 0 && a.rgba[i] > 100;
                }
                if (most > 1 && edgeNear(x, y)) {
                    ++excused;
                    continue;
                }
                largest = std::max(largest, most);
                different += most > 1;
            }
        std::cout << "offset " << offset << ": largest difference " << largest << "/255, " << excused
                  << " pixels at edges excused\n";
        EXPECT_GT(bright, 10'000);
        EXPECT_EQ(different, 0);
        EXPECT_LT(excused, 50);
    }
}

TEST_F(RayTracedTest, SameBytesForAnyNumberOfThreads) {
    const char* const before = std::getenv("SHADOWLAB_THREADS");
    const std::string kept = before ? before : "";
    std::vector<image::Image> pictures;
    std::vector<std::vector<std::uint8_t>> visibility;
    for (const char* threads : {"1", "2", "7"}) {
        ::setenv("SHADOWLAB_THREADS", threads, 1);
        picture::Session session(testing::snapshot(shinyScene()));
        picture::Slot slot = picture::Session::makeSlot("ray-traced");
        const auto frame = render(session, slot, {201, 99}, {{"visibility", 0}});
        pictures.push_back(picture::PictureEncoder().encode(slot.target.color, 1.0f));
        visibility.push_back(picture::readVisibility(picture::findStage(frame, {"visibility", 0})).greyAlpha);
    }
    before ? ::setenv("SHADOWLAB_THREADS", kept.c_str(), 1) : ::unsetenv("SHADOWLAB_THREADS");
    EXPECT_EQ(pictures[0], pictures[1]);
    EXPECT_EQ(pictures[0], pictures[2]);
    EXPECT_EQ(visibility[0], visibility[1]);
    EXPECT_EQ(visibility[0], visibility[2]);
}

// The rasteriser's triangles are checked by the ray, so the two can differ at ties only.
TEST_F(RayTracedTest, ReceiversFromAnIdBufferAreThoseOfRays) {
    const auto snapshot = testing::snapshot(shinyScene());
    const TruthComparison sum =
        compareWithTruth(snapshot, "ray-traced", {"receivers=id-buffer"}, {320, 240}, 0, kTiePx);
    EXPECT_GT(sum.lit, 5000);
    EXPECT_GT(sum.shadowed, 1000);
    EXPECT_EQ(sum.wrong(), 0) << sum;

    picture::Session session(snapshot);
    std::vector<std::vector<std::uint8_t>> visibility;
    for (const char* receivers : {"traced", "id-buffer"}) {
        picture::Slot slot = picture::Session::makeSlot("ray-traced");
        params::setFromText(params::find(slot.params, "receivers", "ray-traced"), receivers, "ray-traced");
        const auto frame = render(session, slot, {320, 240}, {{"visibility", 0}});
        visibility.push_back(picture::readVisibility(picture::findStage(frame, {"visibility", 0})).greyAlpha);
    }
    long different = 0;
    for (std::size_t i = 0; i < visibility[0].size(); ++i)
        different += visibility[0][i] != visibility[1][i];
    EXPECT_LT(different, 10);
}

// The comparison must see the classical fault, or it proves nothing.
TEST_F(RayTracedTest, WithoutExcludingTheSourceThereIsAcne) {
    const auto scene = testing::snapshot(testing::simpleScene());
    const TruthComparison sum = compareWithTruth(scene, "ray-traced", {"exclude-source=false"}, {160, 120}, 0, kTiePx);
    EXPECT_GT(sum.falseShadow, 200) << sum;
}

TEST_F(RayTracedTest, ProbeNamesWhatIsInTheWay) {
    scene::Scene scene = testing::floorScene();
    testing::addObject(scene, scene::makeBox({1, 1, 1}), testing::translation({0, 1.5, 0})).name = "crate";
    scene.camera.positionWorld = {0, 0.5, 3};
    scene.lights.push_back(testing::pointLight({0, 5, 0}));
    picture::Slot slot = picture::Session::makeSlot("ray-traced");
    View view;
    view.camera = scene.camera;
    view.size = {11, 11};
    const Probe probe = slot.technique->probe(testing::snapshot(scene), view, {5, 5}, 0);
    ASSERT_EQ(probe.tree.size(), 2u);
    EXPECT_EQ(probe.tree[0].parent, -1);
    EXPECT_EQ(probe.tree[1].parent, 0);
    EXPECT_EQ(probe.tree[1].facts[0].value, "blocked by crate");
}

} // namespace
} // namespace shadowlab
