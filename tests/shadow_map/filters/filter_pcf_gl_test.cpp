// Percentage-closer filtering is an average of hard comparisons and nothing else, however few lookups it takes.
//   one texel          RadiusZeroIsTheHardMapBitForBit
//   fewer lookups      LookupsBetweenTexelsAreThePlainLoop, ThePlainLoopIsTheOneThatComparesNearest;
//                      naive: AnAverageOfDepthsIsNoAverageOfComparisons
//   four weighted      TheSamplersFourAreHardComparisonsWeighted
//   range              EveryFilterStaysBetweenDarkAndLit
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include "tests/support/gl_fixture.h"
#include "tests/support/light_shares.h"
#include "tests/support/other_shaders.h"
#include "tests/support/scenes.h"

namespace shadowlab {
namespace {

using testing::LightShares;
using testing::OtherShaders;
using testing::ShadowMapSlot;
using PcfTest = testing::GlTest;

constexpr ivec2 kSize{160, 120}, kSmall{96, 72};

/// The simple scene under a sun, or under a lamp among the objects, which has six maps. The eye is so close to edges of shadows
/// that texels are large, also of a fine map.
enum class Lit { bySun, byLamp };
scene::Snapshot scene(Lit lit) {
    scene::Scene scene = testing::simpleScene();
    scene.lights = {lit == Lit::bySun ? testing::directionalLight({0.5, -1, 0.25})
                                      : testing::pointLight({-0.2, 1.7, -0.3})};
    scene.camera.positionWorld = {0.3, 3, 4};
    scene.camera.targetWorld = {-0.3, 0.2, 0.6};
    scene.camera.fovYDegrees = 25;
    return testing::snapshot(scene);
}

struct Difference {
    int surfaces = 0, between = 0, differing = 0; ///< between: neither dark nor lit
    float largest = 0;
    Difference(const LightShares& a, const LightShares& b) {
        for (std::size_t i = 0; i < a.values.size(); ++i) {
            surfaces += a.values[i] != testing::kNoShare;
            between += a.values[i] > 0 && a.values[i] < 1;
            differing += a.values[i] != b.values[i];
            largest = std::max(largest, std::abs(a.values[i] - b.values[i]));
        }
    }
};

std::string resolutionSetting(int resolution) { return "resolution=" + std::to_string(resolution); }

TEST_F(PcfTest, RadiusZeroIsTheHardMapBitForBit) {
    for (const Lit lit : {Lit::bySun, Lit::byLamp}) {
        ShadowMapSlot slot(scene(lit));
        for (const char* mode :
             {"none", "constant", "slope-scaled", "normal-offset", "receiver-plane", "dual-depth", "adaptive"}) {
            const std::vector<std::string> hard = {std::string("bias-mode=") + mode, "resolution=256", "filter=hard"};
            const std::vector<std::string> zero = {hard[0], hard[1], "filter=pcf", "pcf-radius=0"};
            const LightShares expected = slot.shares(hard, kSize);
            const Difference difference(expected, slot.shares(zero, kSize));
            EXPECT_GT(difference.surfaces, 10000);
            EXPECT_GT(std::ranges::count(expected.values, 0.0f), 1000);
            EXPECT_EQ(difference.between, 0);
            EXPECT_EQ(difference.differing, 0) << mode;
            EXPECT_EQ(slot.radiance(hard, kSize), slot.radiance(zero, kSize)) << mode;
        }
    }
}

// Where all texels are compared with one depth, (r + 1) x (r + 1) lookups between them do for (2 r + 1) x (2 r + 1) of their
// own. No tolerance: the counts are whole numbers.
TEST_F(PcfTest, LookupsBetweenTexelsAreThePlainLoop) {
    for (const Lit lit : {Lit::bySun, Lit::byLamp}) {
        ShadowMapSlot fewer(scene(lit)), plain(scene(lit));
        int between = 0;
        for (const char* mode : {"none", "constant", "slope-scaled", "normal-offset", "dual-depth"})
            for (const int resolution : {100, 512, 2048})
                for (const int radius : {0, 1, 2, 3, 7}) {
                    if (lit == Lit::byLamp && resolution > 512) continue; // six of them, and nothing new
                    const std::vector<std::string> settings = {std::string("bias-mode=") + mode, "fit=scene",
                                                               resolutionSetting(resolution), "filter=pcf",
                                                               "pcf-radius=" + std::to_string(radius)};
                    const LightShares asDrawn = fewer.shares(settings, kSmall);
                    const OtherShaders loops("shadow_map/plain_loops");
                    const Difference difference(asDrawn, plain.shares(settings, kSmall));
                    EXPECT_GT(difference.surfaces, 4000);
                    EXPECT_GE(difference.between, radius == 0 ? 0 : 10) << mode << ", " << resolution << ", " << radius;
                    EXPECT_EQ(difference.differing, 0) << mode << ", " << resolution << ", " << radius;
                    between += difference.between;
                }
        EXPECT_GT(between, 30000);
        std::cout << between << " pixels between dark and lit, all alike\n";
    }
}

// With slope-bias=0 the receiver's plane is left out of account, and all texels are compared with the point's own depth; but
// each still has a lookup of its own, and the sampler takes the nearest. The other modes without their offsets do the same.
TEST_F(PcfTest, ThePlainLoopIsTheOneThatComparesNearest) {
    ShadowMapSlot fewer(scene(Lit::bySun)), nearest(scene(Lit::bySun));
    for (const char* mode : {"bias-mode=constant", "bias-mode=slope-scaled", "bias-mode=normal-offset"})
        for (const int resolution : {100, 512, 2048})
            for (const int radius : {1, 2, 7}) {
                std::vector<std::string> settings = {mode,
                                                     "constant-bias=0",
                                                     "slope-bias=0",
                                                     "normal-offset=0",
                                                     resolutionSetting(resolution),
                                                     "pcf-radius=" + std::to_string(radius)};
                const LightShares asDrawn = fewer.shares(settings, kSmall);
                settings[0] = "bias-mode=receiver-plane";
                const Difference difference(asDrawn, nearest.shares(settings, kSmall));
                EXPECT_GT(difference.between, 50);
                EXPECT_EQ(difference.differing, 0) << mode << ", " << resolution << ", " << radius;
            }
}

TEST_F(PcfTest, AnAverageOfDepthsIsNoAverageOfComparisons) {
    const std::vector<std::string> settings = {"bias-mode=constant", "resolution=256", "fit=scene", "pcf-radius=2"};
    ShadowMapSlot slot(scene(Lit::bySun));
    const LightShares compared = slot.shares(settings, kSize);
    const OtherShaders averages("shadow_map/averaged_depths");
    std::vector<std::string> averagedSettings = settings;
    averagedSettings.emplace_back("filter=pcss");
    const LightShares averaged = slot.shares(averagedSettings, kSize);
    EXPECT_GT(Difference(compared, averaged).between, 500);
    EXPECT_EQ(Difference(averaged, compared).between, 0) << "as hard as without a filter";
    EXPECT_GT(Difference(averaged, compared).differing, 500);
}

// hw2x2 answers with one comparison of four texels. Samplers hold the weights in fixed point, with eight bits or more: along
// each of two axes that is off by half of 1/256.
TEST_F(PcfTest, TheSamplersFourAreHardComparisonsWeighted) {
    constexpr double kWeightRounding = 1.0 / 256;
    ShadowMapSlot sampler(scene(Lit::bySun)), four(scene(Lit::bySun));
    float largest = 0;
    for (const char* mode : {"none", "constant", "slope-scaled", "normal-offset", "receiver-plane", "adaptive"})
        for (const int resolution : {100, 512}) {
            const std::vector<std::string> settings = {std::string("bias-mode=") + mode, "filter=hw2x2", "fit=scene",
                                                       resolutionSetting(resolution)};
            const LightShares asDrawn = sampler.shares(settings, kSize);
            const OtherShaders loops("shadow_map/plain_loops");
            const Difference difference(asDrawn, four.shares(settings, kSize));
            EXPECT_GT(difference.between, 50);
            EXPECT_LE(difference.largest, kWeightRounding) << mode << ", " << resolution;
            largest = std::max(largest, difference.largest);
        }
    std::cout << "largest difference " << largest << "\n";
}

TEST_F(PcfTest, EveryFilterStaysBetweenDarkAndLit) {
    for (const Lit lit : {Lit::bySun, Lit::byLamp}) {
        ShadowMapSlot slot(scene(lit));
        for (const char* filter : {"hard", "hw2x2", "pcf", "disc", "pcss", "vsm", "esm", "evsm", "msm"}) {
            const LightShares shares = slot.shares(
                {std::string("filter=") + filter, "resolution=256", "pcf-radius=3", "light-radius=0.1"}, kSize);
            int surfaces = 0, dark = 0, lit = 0;
            for (const float share : shares.values) {
                if (share == testing::kNoShare) continue;
                ++surfaces;
                dark += share == 0, lit += share == 1;
                EXPECT_TRUE(share >= 0 && share <= 1) << filter << ": " << share; // false for NaN as well
            }
            EXPECT_GT(surfaces, 10000);
            EXPECT_GT(dark, 500) << filter;
            EXPECT_GT(lit, 500) << filter;
        }
    }
}

} // namespace
} // namespace shadowlab
