// More volumes around a point than a stencil of eight bits can count: sheets over a floor, all in each other's shadow.
// SPDX-License-Identifier: MIT
#include "techniques/foundation/scene/model/shapes.h"
#include "tests/support/gl_fixture.h"
#include "tests/support/scenes.h"
#include "tests/support/truth_comparison.h"

namespace shadowlab {
namespace {

using testing::compareWithTruth;
using testing::kTiePx;
using testing::TruthComparison;
using Overlaps = testing::GlTest;

constexpr ivec2 kSize{160, 120};
const std::string kTechniques[] = {"shadow-volume-zpass", "shadow-volume-zfail", "shadow-volume"};

/// Squares of 2 m over each other, 1 cm apart: as one mesh, or each an object of its own.
scene::Scene sheets(int count, bool oneMesh, bool sun) {
    scene::Scene scene = testing::floorScene();
    std::vector<dvec3> corners;
    for (int i = 0; i < count; ++i) {
        const double y = 1 + 0.01 * i;
        const std::vector<dvec3> sheet = {{-1, y, -1}, {-1, y, 1}, {1, y, 1}, {-1, y, -1}, {1, y, 1}, {1, y, -1}};
        corners.insert(corners.end(), sheet.begin(), sheet.end());
        if (!oneMesh) testing::addObject(scene, testing::triangleSoup(std::exchange(corners, {})));
    }
    if (oneMesh) testing::addObject(scene, testing::triangleSoup(corners));
    scene.lights = {sun ? testing::directionalLight({0, -1, 0}) : testing::pointLight({0, 10, 0})};
    return scene;
}

TruthComparison compare(const scene::Scene& scene, const std::string& technique, std::vector<std::string> settings) {
    if (technique == "shadow-volume-zpass") settings.emplace_back("eye-correction=true");
    settings.emplace_back("repair=false");
    return compareWithTruth(testing::snapshot(scene), technique, settings, kSize, 0, kTiePx);
}

TEST_F(Overlaps, AnyNumberOfSheetsCastsOneShadow) {
    for (const bool sun : {false, true})
        for (const int count : {255, 256, 257, 512})
            for (const std::string& technique : kTechniques) {
                const TruthComparison one = compare(sheets(count, true, sun), technique, {});
                EXPECT_EQ(one.wrong(), 0) << technique << ", " << count << " sheets: " << one;
                EXPECT_GT(one.shadowed, 1000);
                EXPECT_GT(one.lit, 1000);
            }
}

TEST_F(Overlaps, SoDoSheetsThatAreObjectsOfTheirOwn) {
    for (const std::string& technique : kTechniques) {
        const TruthComparison one = compare(sheets(256, false, false), technique, {});
        EXPECT_EQ(one.wrong(), 0) << technique << ": " << one;
        EXPECT_GT(one.shadowed, 1000);
    }
}

// Under the sun all edges lie on four lines, so the count goes from nothing to 256 at once: the shadow is gone.
TEST_F(Overlaps, AStencilOfEightBitsTakes256ForNone) {
    for (const std::string& technique : kTechniques) {
        const TruthComparison wrapped = compare(sheets(256, true, true), technique, {"counter=stencil"});
        EXPECT_GT(wrapped.falseLit, 300) << "all of the floor's shadow that is in view: " << technique << ": "
                                         << wrapped;
        const TruthComparison oneMore = compare(sheets(257, true, true), technique, {"counter=stencil"});
        EXPECT_LT(oneMore.falseLit, 30) << "what the lowest sheet receives: " << technique << ": " << oneMore;
    }
}

TEST_F(Overlaps, FloatsCountWhatTheStencilCounts) {
    const scene::Scene scene = testing::simpleScene();
    for (const std::string& technique : kTechniques)
        for (const char* twoSided : {"two-sided=true", "two-sided=false"}) {
            const auto stencil =
                testing::renderVisibility(testing::snapshot(scene), technique, {"counter=stencil", twoSided}, kSize, 0);
            const auto floats =
                testing::renderVisibility(testing::snapshot(scene), technique, {"counter=float", twoSided}, kSize, 0);
            EXPECT_EQ(stencil.greyAlpha, floats.greyAlpha) << technique << ", " << twoSided;
            EXPECT_GT(std::ranges::count(floats.greyAlpha, 0.0f), 1000);
        }
}

} // namespace
} // namespace shadowlab
