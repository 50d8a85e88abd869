// A variance is the mean square less the squared mean. Where the depths hardly differ, these are nearly equal, and what is left
// of them is rounding.
//   M13 digits  TheVarianceOfFloatsIsNegativeByRoundingOnly; naive: HalfPrecisionLosesTheVariance
//       centre  MomentsAreOfDepthsAroundZero, DepthsAroundZeroKeepMoreDigits (naive: depths from 0 to 1)
//       acne    ADefaultFloorIsLit; naive: WithoutALeastDeviationRoundingIsAcne
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <random>

#include "app/context/assets.h"
#include "techniques/foundation/scene/load/load.h"
#include "techniques/foundation/scene/model/shapes.h"
#include "tests/shadow_map/filters/moment_texels.h"
#include "tests/support/gl_fixture.h"
#include "tests/support/light_shares.h"
#include "tests/support/scenes.h"

namespace shadowlab {
namespace {

using shadow_map::MomentMaker;
using testing::FilledMap;
using testing::FilterParams;
using testing::LightShares;
using testing::ShadowMapSlot;
using Format = FilterParams::MomentFormat;
using VarianceTest = testing::GlTest;

// Rounding of float numbers is 2^-24 of what is rounded. The mean of three is two sums and a quotient, for which GLSL allows
// five such errors: seven; rows and columns: fourteen. The mean square has one more, and counts once; the mean counts twice.
constexpr double kRounding = 1.0 / (1 << 24);
constexpr double kLostDigits = (14 + 1 + 2 * 14) * kRounding;

/// Over all texels of some maps: variances in proportion to the mean square.
struct Variances {
    double least = 1e300;
    int negative = 0, texels = 0;
    void add(const std::vector<vec4>& moments) {
        for (const vec4& m : moments) {
            const double variance = double(m.y) - double(m.x) * double(m.x);
            ++texels;
            negative += variance < 0;
            if (variance < 0) least = std::min(least, variance / m.y);
        }
    }
};

FilterParams vsm(Format format) {
    FilterParams params;
    params.kind = shadow_map::filterNamed("vsm");
    params.momentFormat = format;
    return params;
}

/// Of planes that face the light at many depths, of planes aslant, and of the built-in scenes.
Variances variancesOf(Format format) {
    Variances result;
    MomentMaker maker;
    std::mt19937 random(1);
    std::uniform_real_distribution<double> anyDepth(0.0, 1.0);
    for (int i = 0; i < 64; ++i) {
        const double depth = anyDepth(random);
        for (const double slope : {0.0, 1e-6, 1e-4})
            result.add(testing::momentTexels(
                maker,
                testing::filledMap(32,
                                   [&](int x, int y) { return std::clamp(depth + slope * (x + 0.7 * y), 0.0, 1.0); }),
                vsm(format)));
    }
    const auto root = context::assetsRoot();
    for (const std::string& name : scene::builtInScenes(root)) {
        const scene::Snapshot snapshot = scene::loadScene(name, {.assetsRoot = root, .allowed = {}, .limits = {}});
        const FilledMap drawn = testing::drawnMap(snapshot, 0, 128);
        if (drawn.maps.layers() > 0) result.add(testing::momentTexels(maker, drawn, vsm(format)));
    }
    std::cout << result.texels << " texels, " << result.negative << " of them negative, down to " << result.least
              << " of the mean square\n";
    EXPECT_GT(result.texels, 300000);
    return result;
}

TEST_F(VarianceTest, TheVarianceOfFloatsIsNegativeByRoundingOnly) {
    EXPECT_GE(variancesOf(Format::float32).least, -kLostDigits);
}

// Sixteen bits have 11 digits: 2^-11 is as much as the variance of depths that span a twenty-fifth of the map.
TEST_F(VarianceTest, HalfPrecisionLosesTheVariance) {
    const Variances half = variancesOf(Format::float16);
    EXPECT_LT(half.least, -1.0 / 4096);
    EXPECT_GT(half.negative, half.texels / 10);
}

// The shaders do so: half of the map's range is 0, for every power of the depth.
TEST_F(VarianceTest, MomentsAreOfDepthsAroundZero) {
    MomentMaker maker;
    for (const double depth : {0.0, 0.25, 0.5, 0.75, 1.0}) {
        const FilledMap filled = testing::filledMap(4, [&](int, int) { return depth; });
        for (const shadow_map::FilterKind kind : {shadow_map::filterNamed("vsm"), shadow_map::filterNamed("msm")}) {
            FilterParams params;
            params.kind = kind;
            const vec4 moments = testing::momentTexels(maker, filled, params)[5];
            const int powers = kind == shadow_map::filterNamed("vsm") ? 2 : 4;
            for (int i = 0; i < powers;
                 ++i) // z itself is off by two roundings, and its fourth power by four times that
                EXPECT_NEAR(moments[i], std::pow(2 * depth - 1, i + 1), 1e-6) << depth << ", power " << i + 1;
        }
    }
}

/// The variance of nine equal depths, in floats as the shaders find it.
float varianceOfNine(float depth) {
    const auto meanOfThree = [](float v) { return (v + v + v) / 3.0f; };
    const float mean = meanOfThree(meanOfThree(depth)), square = meanOfThree(meanOfThree(depth * depth));
    return square - mean * mean;
}

TEST_F(VarianceTest, DepthsAroundZeroKeepMoreDigits) {
    std::mt19937 random(1);
    std::uniform_real_distribution<float> anyDepth(0.0f, 1.0f);
    double centredSum = 0, plainSum = 0, centredWorst = 0, plainWorst = 0;
    int negative = 0;
    constexpr int kDepths = 10000;
    for (int i = 0; i < kDepths; ++i) {
        const float depth = anyDepth(random);
        const double plain = varianceOfNine(depth);
        const double centred = varianceOfNine(2 * depth - 1) / 4.0; // of the same range
        negative += plain < 0;
        plainSum += std::abs(plain), centredSum += std::abs(centred);
        plainWorst = std::max(plainWorst, std::abs(plain)), centredWorst = std::max(centredWorst, std::abs(centred));
    }
    std::cout << "from 0 to 1: " << plainSum / kDepths << " and at most " << plainWorst << ", " << negative
              << " negative; from -1 to 1: " << centredSum / kDepths << " and at most " << centredWorst << "\n";
    EXPECT_GT(negative, kDepths / 10);
    EXPECT_LT(2 * centredSum, plainSum);
    EXPECT_LT(3 * centredWorst, plainWorst);
}

/// Where in the map's range of depths a floor lies: near its ends numbers from -1 to 1 are coarsest.
enum class End { nearSide, farSide };

/// A floor under a sun so high, and nothing that shadows it: another floor below, and for the far side something high up that
/// is beside it and casts its shadow away from it.
scene::Snapshot floorUnderSun(double elevationDegrees, End end) {
    const double elevation = glm::radians(elevationDegrees);
    scene::Scene scene = testing::floorScene();
    scene.lights.push_back(testing::directionalLight(
        {std::cos(elevation) * std::cos(0.6), -std::sin(elevation), std::cos(elevation) * std::sin(0.6)}));
    testing::addObject(scene, scene::makeQuad({10, 10}),
                       testing::translation({0, end == End::nearSide ? -5 : -0.5, 0}));
    if (end == End::farSide) testing::addObject(scene, scene::makeQuad({1, 1}), testing::translation({5.6, 5, 0}));
    return testing::snapshot(scene);
}

constexpr ivec2 kSize{128, 96};

/// The least share of light on a floor that has all of it, and in how many pixels it is less than nine tenths: acne.
struct Acne {
    int pixels = 0, acne = 0;
    float least = 1;
    explicit Acne(const LightShares& shares) {
        for (const float share : shares.values) {
            if (share == testing::kNoShare) continue;
            ++pixels;
            acne += !(share >= 0.9f);
            least = std::min(least, share);
        }
        EXPECT_GT(pixels, 5000);
    }
};

// Two per cent are for what a filter says of a plane aslant, which is not one depth; rounding is much less. Of evsm it is more
// where light grazes, since its negative exponential bends there: up to a tenth, at one degree in a coarse map.
TEST_F(VarianceTest, ADefaultFloorIsLit) {
    ShadowMapSlot slot(nullptr);
    float leastOfAll = 1;
    for (const double elevation : {1.0, 5.0, 10.0, 30.0, 60.0, 90.0})
        for (const End end : {End::nearSide, End::farSide}) {
            slot.setScene(floorUnderSun(elevation, end));
            for (const std::string filter : {"vsm", "esm", "evsm", "msm"}) {
                const char* resolution = end == End::nearSide ? "resolution=256" : "resolution=1024";
                const Acne found(slot.shares({"filter=" + filter, resolution}, kSize));
                const bool bends = filter == "evsm" && elevation == 1;
                EXPECT_EQ(found.acne, 0) << elevation << " " << filter << " " << resolution;
                EXPECT_GE(found.least, bends ? 0.9f : 0.98f) << elevation << " " << filter << " " << resolution;
                leastOfAll = std::min(leastOfAll, found.least);
            }
        }
    std::cout << "least share of light: " << leastOfAll << "\n";
}

// Two things keep rounding from being taken for a shadow: a point is moved toward the light by a little, and depths are never
// taken to vary by nothing. Without both, 32 bits are not enough; 16 bits ask for a hundred times more of the second. (Of 16 bits
// the far side is worse: drivers that round toward zero make depths nearer to the light there.)
TEST_F(VarianceTest, WithoutALeastDeviationRoundingIsAcne) {
    ShadowMapSlot slot(nullptr);
    const auto acne = [&](End end, const char* format, const char* least) {
        slot.setScene(floorUnderSun(89, end)); // so nearly a plane of one depth that its own variance is no help
        const Acne found(slot.shares({"filter=vsm", "bias-mode=none", "resolution=512", format, least}, kSize));
        std::cout << format << ", " << least << ": " << found.acne << " of " << found.pixels << ", down to "
                  << found.least << "\n";
        return found.acne;
    };
    EXPECT_GT(acne(End::nearSide, "moment-format=32f", "least-deviation=0"), 500);
    EXPECT_GT(acne(End::farSide, "moment-format=16f", "least-deviation=0"), 500);
    EXPECT_GT(acne(End::farSide, "moment-format=16f", "least-deviation=0.0001"), 500);
    EXPECT_EQ(acne(End::farSide, "moment-format=16f", "least-deviation=0.01"), 0);
    for (const End end : {End::nearSide, End::farSide})
        EXPECT_EQ(acne(end, "moment-format=32f", "least-deviation=0.0001"), 0); // the default
}

} // namespace
} // namespace shadowlab
