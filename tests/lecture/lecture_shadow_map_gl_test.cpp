// The lecture's shadow map against the truth: wrong beside the edges of shadows, by no more than its texels reach, and nowhere else.
// SPDX-License-Identifier: MIT
#include <cmath>

#include <glm/gtc/constants.hpp>

#include "techniques/foundation/scene/model/shapes.h"
#include "tests/support/gl_fixture.h"
#include "tests/support/scenes.h"
#include "tests/support/truth_comparison.h"

namespace shadowlab {
namespace {

using testing::compareWithTruth;
using testing::TruthComparison;
using LectureShadowMapTest = testing::GlTest;

constexpr ivec2 kSize{320, 240};

scene::Scene lampAndSun() {
    scene::Scene scene = testing::simpleScene(); // floor, box, sphere and torus
    scene.lights.push_back(testing::directionalLight({0.5, -1, 0.25}));
    return scene;
}

/// How many pixels `texels` of the map cover where the eye sees that point. The map takes in a ball around all casters, a hundredth
/// larger than that of their box; from a lamp at distance D a texel covers 2 tan(asin(radius / D)) / resolution of a metre at a metre,
/// and 1 / cos of the angle of incidence as much on a surface that is not turned toward the light.
testing::TieRadius reachOf(const scene::Scene& scene, int light, int resolution, double texels) {
    const scene::Light source = scene.light(light);
    scene::Bounds box;
    for (std::size_t i = 1; i < scene.objects.size(); ++i) // all but the floor, which shadows nothing
        box.include(scene::boundsWorld(scene.objects[i]));
    const double radius = 0.505 * glm::length(box.upperWorld - box.lowerWorld);
    const dvec3 center = 0.5 * (box.lowerWorld + box.upperWorld);
    const bool isParallel = source.type == scene::LightType::directional;
    const double tanHalf = std::tan(std::asin(radius / glm::length(source.positionWorld - center)));
    const double tanOfView = std::tan(scene.camera.fovYDegrees * glm::pi<double>() / 360.0);
    return [=](const std::optional<trace::EyeHit>& hit) {
        if (!hit) return testing::kTiePx;
        const dvec3 offset = source.positionWorld - hit->positionWorld;
        const double texel = isParallel ? 2 * radius / resolution : 2 * tanHalf / resolution * glm::length(offset);
        const dvec3 toLight = isParallel ? -source.directionWorld : glm::normalize(offset);
        // A surface that the light only grazes is not cut off before 50 texels' worth of one.
        const double onSurface = texel / std::max(0.02, std::abs(glm::dot(toLight, hit->geometricNormalWorld)));
        return std::max(testing::kTiePx, texels * onSurface * kSize.y / (2 * tanOfView * hit->distance));
    };
}

TEST_F(LectureShadowMapTest, IsWrongOnlyBesideTheEdgesOfShadows) {
    const scene::Scene scene = lampAndSun();
    const scene::Snapshot snapshot = testing::snapshot(scene);
    for (const int light : {0, 1})
        for (const int resolution : {64, 256, 1024}) {
            const auto image = testing::renderVisibility(snapshot, "lecture-shadow-map",
                                                         {"resolution=" + std::to_string(resolution)}, kSize, light);
            const auto compare = [&](const testing::TieRadius& excusedPx) {
                return testing::JudgedPicture(snapshot, kSize, light, excusedPx).compare(image);
            };
            const TruthComparison all = compare([](const auto&) { return testing::kTiePx; });
            EXPECT_GT(all.lit, 10000);
            EXPECT_GT(all.shadowed, 1000);
            // As many as texels are large: 7,000 divided by the resolution under the lamp, and more under the sun.
            EXPECT_GT(all.wrong(), 3500 / resolution) << all;
            // Half a diagonal of a texel, 0.7, for the place that is asked; two for the bias, which delays the beginning of a
            // shadow; one because an edge of a curved caster lies deeper than the texel says.
            const TruthComparison beyond = compare(reachOf(scene, light, resolution, 4));
            EXPECT_EQ(beyond.wrong(), 0) << "light " << light << ", " << resolution << " texels: " << beyond;
            if (resolution > 64) continue;
            const TruthComparison nearer = compare(reachOf(scene, light, resolution, 0.1));
            EXPECT_GT(nearer.wrong(), 20) << "else four texels would be no bound: " << nearer;
        }
}

TEST_F(LectureShadowMapTest, SmallerTexelsAreLessWrong) {
    const scene::Snapshot snapshot = testing::snapshot(lampAndSun());
    const auto wrong = [&](const char* resolution) {
        return compareWithTruth(snapshot, "lecture-shadow-map", {resolution}, kSize, 0, testing::kTiePx).wrong();
    };
    const int coarse = wrong("resolution=64"), fine = wrong("resolution=1024");
    EXPECT_GT(coarse, 80);
    EXPECT_LT(fine * 8, coarse) << "texels are a sixteenth as wide";
}

// "A surface shadows itself": about half of all points lie behind the one depth that their texel keeps.
TEST_F(LectureShadowMapTest, WithoutABiasLitSurfacesShadowThemselves) {
    scene::Scene scene = lampAndSun();
    testing::addObject(scene, scene::makeBox({2, 0.1, 2}),
                       testing::translation({0, 0.05, 2.5})); // a plate that casts, seen aslant
    const scene::Snapshot snapshot = testing::snapshot(scene);
    const auto with = compareWithTruth(snapshot, "lecture-shadow-map", {}, kSize, 0, testing::kTiePx);
    const auto without = compareWithTruth(snapshot, "lecture-shadow-map", {"bias=0"}, kSize, 0, testing::kTiePx);
    EXPECT_GT(with.lit, 10000);
    EXPECT_LT(with.falseShadow, 100) << with;
    EXPECT_GT(without.falseShadow, 3000) << without;
}

// Depths that are pushed away by more than a thin caster's distance to its receiver let the light through where they touch.
TEST_F(LectureShadowMapTest, WithTooMuchBiasShadowsBeginBehindTheirCasters) {
    scene::Scene scene = testing::floorScene();
    testing::addObject(scene, scene::makeBox({3, 1, 0.02}), testing::translation({0, 0.5, 0})); // stands on the floor
    scene.lights.push_back(testing::directionalLight({0.25, -1, 0.5}));
    const scene::Snapshot snapshot = testing::snapshot(scene);
    const auto with = [&](const char* bias) {
        return compareWithTruth(snapshot, "lecture-shadow-map", {"resolution=256", bias}, kSize, 0, testing::kTiePx);
    };
    const TruthComparison little = with("bias=2"), much = with("bias=16");
    EXPECT_GT(little.lit, 10000);
    EXPECT_GT(little.shadowed, 500);
    EXPECT_GT(much.falseLit, 100) << much;
    EXPECT_LT(little.falseLit * 4, much.falseLit) << little;
}

} // namespace
} // namespace shadowlab
