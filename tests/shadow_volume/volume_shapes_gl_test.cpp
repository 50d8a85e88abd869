// How volumes are built, where they end and who extrudes them: every choice that is meant to be right is, from every eye, and
// every choice that is a lesson goes wrong where it should.
// SPDX-License-Identifier: MIT
#include <random>

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
using VolumeShapes = testing::GlTest;

constexpr ivec2 kSize{160, 120};

// Isolated pixels at cracks between sides, as in zfail_gl_test.cpp.
constexpr double kCrackShare = 3e-5;

const std::string kZPass = "shadow-volume-zpass", kZFail = "shadow-volume-zfail", kChosen = "shadow-volume";

/// The three techniques, each with the settings that are right from every eye, and without repair.
std::vector<std::pair<std::string, std::vector<std::string>>> allThree(const std::vector<std::string>& settings) {
    std::vector<std::pair<std::string, std::vector<std::string>>> techniques = {
        {kZPass, {"eye-correction=true"}}, {kZFail, {}}, {kChosen, {"repair=false"}}};
    for (auto& [technique, its] : techniques)
        its.insert(its.end(), settings.begin(), settings.end());
    return techniques;
}

TruthComparison overClasses(const std::vector<HardClass>& classes, const std::string& technique,
                            const std::vector<std::string>& settings, int perClass) {
    TruthComparison sum;
    for (const bool directional : {false, true})
        for (const HardClass hardClass : classes)
            for (int i = 0; i < perClass; ++i)
                sum += compareWithTruth(
                    testing::snapshot(testing::hardScene(hardClass, static_cast<unsigned>(i), directional)), technique,
                    settings, kSize, 0, kTiePx);
    return sum;
}

const std::vector<HardClass> kAll(std::begin(testing::kHardClasses), std::end(testing::kHardClasses));

int perClass() { return std::getenv("SHADOWLAB_LONG") ? 40 : 2; }

void expectExact(const std::vector<HardClass>& classes, const std::vector<std::string>& settings) {
    for (const auto& [technique, its] : allThree(settings)) {
        const TruthComparison sum = overClasses(classes, technique, its, perClass());
        EXPECT_LE(sum.wrong(), kCrackShare * sum.compared + 1) << technique << ": " << sum;
        EXPECT_GT(sum.lit, 5000) << technique;
        EXPECT_GT(sum.shadowed, 5000) << technique;
    }
}

TEST_F(VolumeShapes, VolumesMayEndAtInfinity) { expectExact(kAll, {"volume-end=infinity"}); }

// 1000 m is far beyond these scenes, which are about 10 m across. Where the light is but h = 1/4096 m above a triangle of some metres,
// it is not: the far cap is a triangle as flat as the near one is seen, and passes the light as near as d h / r, about 0.2 m.
TEST_F(VolumeShapes, TheLecturesDistanceIsExactWhenItIsLongEnough) {
    std::vector<HardClass> away = kAll;
    std::erase(away, HardClass::lightOnVertexOrPlane);
    expectExact(away, {"volume-end=distance", "extrusion=1000"});
    expectExact({HardClass::lightOnVertexOrPlane}, {"volume-end=distance", "extrusion=100000"});
}

TEST_F(VolumeShapes, ADistanceTooShortLosesShadowsAndInventsNone) {
    const std::vector<std::string> tooShort = {"volume-end=distance", "extrusion=0.25"};
    for (const auto& [technique, its] : allThree(tooShort)) {
        const TruthComparison sum = overClasses({HardClass::soup, HardClass::torus}, technique, its, 2);
        EXPECT_GT(sum.falseLit, sum.compared / 50) << technique << ": " << sum;
        EXPECT_LE(sum.falseShadow, kCrackShare * sum.compared + 1) << technique << ": " << sum;
    }
}

TEST_F(VolumeShapes, TheLecturesConstructionIsExactForClosedMeshes) {
    expectExact({HardClass::torus}, {"construction=lecture"});
    expectExact({HardClass::torus}, {"construction=lecture", "volume-end=distance", "extrusion=1000"});
}

// "Find the two polygon surfaces that share this edge": a boundary has one, a fan has three or more.
TEST_F(VolumeShapes, TheLecturesConstructionFailsForOpenAndNonManifoldOnes) {
    for (const HardClass hardClass : {HardClass::soup, HardClass::nonManifold, HardClass::lightInMesh}) {
        const TruthComparison sum = overClasses({hardClass}, kZFail, {"construction=lecture"}, 4);
        // Inside a tube little is lit to begin with; cracks would be a pixel or two.
        EXPECT_GT(sum.wrong(), 200) << toText(hardClass) << ": " << sum;
    }
}

TEST_F(VolumeShapes, EitherRemedyForTheFarPlaneIsEnough) {
    for (const char* remedy : {"infinite", "clamp", "infinite-and-clamp"}) {
        const TruthComparison sum =
            overClasses(kAll, kZFail, {"volume-end=infinity", std::string("far-plane=") + remedy}, perClass());
        EXPECT_LE(sum.wrong(), kCrackShare * sum.compared + 1) << remedy << ": " << sum;
        EXPECT_GT(sum.shadowed, 10000) << remedy;
    }
}

TEST_F(VolumeShapes, WithoutARemedyTheFarPlaneCutsVolumesOpen) {
    const TruthComparison sum = overClasses(kAll, kZFail, {"volume-end=infinity", "far-plane=clip"}, 2);
    EXPECT_GT(sum.wrong(), sum.compared / 100) << sum;
}

TEST_F(VolumeShapes, TheProcessorAndTheVertexShaderExtrudeToTheSamePixels) {
    long lit = 0, shadowed = 0;
    for (const std::vector<std::string>& end :
         {std::vector<std::string>{"volume-end=receivers"}, {"volume-end=infinity"}, {"volume-end=distance"}})
        for (const auto& [technique, its] : allThree(end))
            for (const HardClass hardClass : testing::kHardClasses) {
                const auto scene = testing::snapshot(testing::hardScene(hardClass, 3, hardClass == HardClass::torus));
                std::vector<std::string> onCpu = its;
                onCpu.emplace_back("extrude-on=cpu");
                const auto shader = testing::renderVisibility(scene, technique, its, kSize, 0);
                const auto cpu = testing::renderVisibility(scene, technique, onCpu, kSize, 0);
                EXPECT_EQ(shader.greyAlpha, cpu.greyAlpha) << technique << ", " << toText(hardClass) << ", " << end[0];
                for (std::size_t i = 0; i + 1 < cpu.greyAlpha.size(); i += 2)
                    if (cpu.greyAlpha[i + 1] > 0) ++(cpu.greyAlpha[i] > 0.5f ? lit : shadowed);
            }
    EXPECT_GT(lit, 50000);
    EXPECT_GT(shadowed, 50000);
}

/// From somewhere else, turned some other way, as through a long lens or a wide one: much of the scene is out of view.
scene::Scene seenElsewise(scene::Scene scene, std::mt19937& random) {
    std::uniform_real_distribution<double> share(-1, 1);
    const auto anywhere = [&](double reach) { return reach * dvec3(share(random), share(random), share(random)); };
    scene.camera.positionWorld += anywhere(3);
    scene.camera.targetWorld += anywhere(2);
    scene.camera.fovYDegrees = 40 + 35 * share(random);
    return scene;
}

// Casters left out, volumes that end where the receivers in view do, and scissors: no pixel may tell.
TEST_F(VolumeShapes, KeepingToTheReceiversInViewChangesNoPixel) {
    std::mt19937 random(3);
    long shadowed = 0, different = 0, compared = 0;
    for (const bool directional : {false, true})
        for (const HardClass hardClass : testing::kHardClasses)
            for (int i = 0; i < perClass(); ++i)
                for (int view = 0; view < 4; ++view) {
                    scene::Scene scene = testing::hardScene(hardClass, static_cast<unsigned>(i), directional);
                    if (view > 0) scene = seenElsewise(std::move(scene), random);
                    const auto snapshot = testing::snapshot(std::move(scene));
                    const auto all =
                        testing::renderVisibility(snapshot, kChosen, {"repair=false", "cull=false"}, kSize, 0);
                    const auto kept = testing::renderVisibility(snapshot, kChosen, {"repair=false"}, kSize, 0);
                    for (std::size_t p = 0; p + 1 < all.greyAlpha.size(); p += 2) {
                        if (all.greyAlpha[p + 1] == 0) continue;
                        ++compared;
                        shadowed += all.greyAlpha[p] == 0;
                        different += all.greyAlpha[p] != kept.greyAlpha[p];
                    }
                }
    EXPECT_GT(shadowed, 100000);
    // Where volumes end is another place: so may a crack be, in either of the two.
    EXPECT_LE(different, 2 * kCrackShare * compared) << compared;
}

} // namespace
} // namespace shadowlab
