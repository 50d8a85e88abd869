// Shadow maps against the exact judge: whatever is wrong is wrong near an edge of the truth, within the texels' reach. Ordinary
// scenes here; the hard ones are in hard_*_gl_test.cpp.
// SPDX-License-Identifier: MIT
#include <cmath>

#include "techniques/foundation/scene/model/shapes.h"
#include "tests/shadow_map/edge_reach.h"
#include "tests/support/gl_fixture.h"
#include "tests/support/scenes.h"

namespace shadowlab {
namespace {

using testing::compareWithTruth;
using testing::TruthComparison;
using ShadowMapTest = testing::GlTest;

constexpr ivec2 kSize{320, 240};
const std::vector<std::string> kHard = {"filter=hard", "resolution=1024"};

void expectOnlyEdgeErrors(const scene::Scene& scene, const std::vector<std::string>& settings, double texels,
                          int resolution = 1024) {
    const auto snapshot = testing::snapshot(scene);
    for (int light = 0; light < static_cast<int>(scene.lights.size()); ++light) {
        const TruthComparison sum = compareWithTruth(snapshot, "shadow-map", settings, kSize, light,
                                                     testing::edgeReach(snapshot, light, resolution, kSize, texels));
        std::cout << scene.light(light).name << ": " << sum << "\n";
        EXPECT_GT(sum.lit, 500);
        EXPECT_GT(sum.shadowed, 500);
        EXPECT_EQ(sum.wrong(), 0) << sum;
        EXPECT_LT(sum.ties, sum.compared / 20) << "edges everywhere: the test says nothing";
    }
}

scene::Light spot(const dvec3& position, const dvec3& direction, double coneDegrees) {
    scene::Light light = testing::pointLight(position);
    light.name = "spot" + std::to_string(static_cast<int>(coneDegrees));
    light.type = scene::LightType::spot;
    light.directionWorld = glm::normalize(direction);
    light.coneDegrees = coneDegrees;
    return light;
}

TEST_F(ShadowMapTest, EveryLightTypeIsWrongOnlyNearEdges) {
    scene::Scene scene = testing::simpleScene();
    scene.lights.push_back(testing::directionalLight({0.5, -1, 0.25}));
    scene.lights.push_back(spot({-1, 5, 3}, {0.2, -1, -0.5}, 60));
    scene.lights.push_back(spot({-1, 3, 2}, {0.2, -1, -0.5}, 150));
    expectOnlyEdgeErrors(scene, kHard, 1.5);
}

TEST_F(ShadowMapTest, PcfIsWrongOnlyWithinItsKernel) {
    scene::Scene scene = testing::simpleScene();
    scene.lights.push_back(testing::directionalLight({0.5, -1, 0.25}));
    expectOnlyEdgeErrors(scene, {"filter=pcf", "pcf-radius=1", "resolution=1024"}, 3.0);
}

TEST_F(ShadowMapTest, CullingChangesNoByte) {
    scene::Scene scene = testing::simpleScene();
    scene.lights.push_back(testing::directionalLight({0.5, -1, 0.25}));
    const auto snapshot = testing::snapshot(scene);
    for (const int light : {0, 1}) {
        const auto with = testing::renderVisibility(snapshot, "shadow-map", {"cull=true"}, kSize, light);
        const auto without = testing::renderVisibility(snapshot, "shadow-map", {"cull=false"}, kSize, light);
        EXPECT_EQ(with.greyAlpha, without.greyAlpha);
    }
}

TEST_F(ShadowMapTest, PcfOfRadiusZeroIsTheHardMap) {
    const auto snapshot = testing::snapshot(testing::simpleScene());
    EXPECT_EQ(testing::renderVisibility(snapshot, "shadow-map", {"filter=hard"}, kSize, 0).greyAlpha,
              testing::renderVisibility(snapshot, "shadow-map", {"filter=pcf", "pcf-radius=0"}, kSize, 0).greyAlpha);
}

} // namespace
} // namespace shadowlab
