// Casters with holes in every technique, against the exact judge: who honours them, who cannot, and what that costs.
// SPDX-License-Identifier: MIT
#include <algorithm>

#include "app/context/assets.h"
#include "techniques/foundation/scene/load/load.h"
#include "techniques/foundation/scene/model/shapes.h"
#include "techniques/registry.h"
#include "tests/shadow_map/edge_reach.h"
#include "tests/support/gl_fixture.h"
#include "tests/support/perforated.h"
#include "tests/support/scenes.h"

namespace shadowlab {
namespace {

using testing::compareWithTruth;
using testing::TruthComparison;
using HolesTest = testing::GlTest;

constexpr ivec2 kSize{320, 240};

scene::Snapshot lattice() {
    return scene::loadScene("lattice", {.assetsRoot = context::assetsRoot(), .allowed = {}, .limits = {}});
}

/// A box of lace with a light in it, over a floor and before a wall: six maps, each with a pattern of its own.
scene::Snapshot lantern() {
    scene::Scene scene = testing::floorScene();
    testing::addObject(scene, scene::makeBox({10, 8, 0.2}), testing::translation({0, 2, -2.5}));
    testing::addObject(scene, scene::makeBox({1, 1, 1}), testing::translation({0.2, 1.3, 0}));
    testing::perforate(scene, 2, {"#####", "#..##", "#.#.#", "##..#", "#####"});
    scene.lights.push_back(testing::pointLight({0.25, 1.25, 0.05}));
    return testing::snapshot(scene);
}

void expectTruthShown(const TruthComparison& sum, int leastShadowed) {
    EXPECT_EQ(sum.wrong(), 0) << sum;
    EXPECT_GT(sum.lit, 2000) << sum;
    EXPECT_GT(sum.shadowed, leastShadowed) << sum;
    EXPECT_LT(sum.ties, sum.compared / 20) << "borders everywhere: the test says nothing; " << sum;
}

TEST_F(HolesTest, TheShadowMapIsWrongOnlyNearEdges) {
    for (const scene::Snapshot& snapshot : {testing::snapshot(testing::perforatedScene()), lantern(), lattice()})
        for (int light = 0; light < static_cast<int>(snapshot->lights.size()); ++light) {
            const TruthComparison sum =
                compareWithTruth(snapshot, "shadow-map", {"filter=hard", "resolution=4096"}, kSize, light,
                                 testing::edgeReach(snapshot, light, 4096, kSize, 1.5));
            std::cout << snapshot->name << "@" << light << ": " << sum << "\n";
            expectTruthShown(sum, 2000);
        }
}

TEST_F(HolesTest, RayTracingIsRight) {
    for (const scene::Snapshot& snapshot : {testing::snapshot(testing::perforatedScene()), lantern(), lattice()})
        for (int light = 0; light < static_cast<int>(snapshot->lights.size()); ++light)
            for (const char* receivers : {"receivers=traced", "receivers=id-buffer"})
                expectTruthShown(compareWithTruth(snapshot, "ray-traced", {receivers}, kSize, light, testing::kTiePx),
                                 2000);
}

// The limit: a volume is bounded by edges of the mesh. Nothing is lit that should not be. (Planar shadows: tests/planar.)
TEST_F(HolesTest, VolumesCastTheHolesAsSolid) {
    const scene::Snapshot snapshot = lattice();
    for (const char* technique : {"shadow-volume-zfail", "shadow-volume-zpass", "shadow-volume"}) {
        const TruthComparison sum = compareWithTruth(snapshot, technique, {}, {160, 120}, 0, testing::kTiePx);
        std::cout << technique << ": " << sum << "\n";
        EXPECT_GT(sum.falseShadow, 400) << technique << ": " << sum;
        EXPECT_GT(sum.together, 40) << technique << ": whole regions, not pixels at cracks; " << sum;
        EXPECT_EQ(sum.coverage, 0) << technique << ": what is seen through holes is seen; " << sum;
        EXPECT_LE(sum.falseLit, 1) << technique << ": " << sum;
    }
}

// Depth pass draws no caps: a caster hides its own from the eye. Through holes they are missing, and more is wrong than the
// shadow alone; whoever may choose counts such casters with depth fail.
TEST_F(HolesTest, OnlyTheTextbooksDepthPassAlsoErrsThroughHoles) {
    const scene::Snapshot snapshot = lattice();
    const testing::JudgedPicture judged(snapshot, kSize, 0, testing::kTiePx);
    const auto wrong = [&](const char* technique, const std::vector<std::string>& settings) {
        return judged.differing(testing::renderVisibility(snapshot, technique, settings, kSize, 0));
    };
    const int fail = wrong("shadow-volume-zfail", {});
    EXPECT_NEAR(wrong("shadow-volume", {}), fail, 20);
    EXPECT_NEAR(wrong("shadow-volume-zpass", {"eye-correction=true"}), fail, 20);
    EXPECT_GT(wrong("shadow-volume-zpass", {}), fail + 2000);
    EXPECT_GT(fail, 2000);
}

// It decides with rays, and neighbours of what it changes next: rays that knew of the holes would never stop.
TEST_F(HolesTest, MendingACountLeavesSolidWhatWasCountedSolid) {
    const scene::Snapshot snapshot = lattice();
    const auto counted = testing::renderVisibility(snapshot, "shadow-volume-zfail", {}, kSize, 0);
    const auto mended = testing::renderVisibility(snapshot, "shadow-volume-zfail", {"repair=true"}, kSize, 0);
    int different = 0, dark = 0;
    for (std::size_t i = 0; i < counted.greyAlpha.size(); i += 2) {
        different += counted.greyAlpha[i] != mended.greyAlpha[i];
        dark += counted.greyAlpha[i] == 0;
    }
    EXPECT_LE(different, 20);
    EXPECT_GT(dark, 5000);
}

// Where nothing casts, all that is left is what is seen, and from which side: through holes, and on the inside of a ball.
TEST_F(HolesTest, EveryTechniqueShowsWhatIsBehindThem) {
    scene::Scene scene = testing::perforatedScene();
    for (scene::Object& object : scene.objects)
        object.castsShadow = false;
    const auto snapshot = testing::snapshot(scene);
    int techniques = 0;
    for (const RegisteredTechnique& registered : techniquesOf(TechniqueGroup::production)) {
        const TechniqueInfo& info = *registered.info;
        if (std::ranges::find(info.stages, "visibility", &StageInfo::id) == info.stages.end()) continue;
        const TruthComparison sum =
            compareWithTruth(snapshot, std::string(info.id), {}, {200, 150}, 0, testing::kTiePx);
        EXPECT_EQ(sum.wrong(), 0) << info.id << ": " << sum;
        EXPECT_GT(sum.lit, 3000) << info.id;
        EXPECT_GT(sum.turnedAway, 300) << info.id;
        EXPECT_GT(sum.background, 1000) << info.id;
        ++techniques;
    }
    EXPECT_GE(techniques, 7);
}

} // namespace
} // namespace shadowlab
