// Light that bleeds through: filters that average moments of depths only tell at most how much light there can be, and where three
// surfaces lie behind each other that is more than there is.
//   M12 closed form  VarianceLetsThroughWhatTheClosedFormSays (naive: bleed-reduction=0)
//                    AnExponentialMapIsTheMeanOfTwoExponentials
//       remedies     EveryRemedyLetsLessThrough, NoBoundIsBelowTheLightAndMomentsAreTheTighterOne
// SPDX-License-Identifier: MIT
#include <map>
#include <tuple>

#include "tests/shadow_map/filters/layer_light.h"
#include "tests/support/gl_fixture.h"

namespace shadowlab {
namespace {

using testing::asNumber;
using testing::bare;
using testing::Deviation;
using testing::deviation;
using testing::LightShares;
using testing::ShadowMapSlot;
using testing::StackedLayers;
using BleedingTest = testing::GlTest;

constexpr ivec2 kSize = StackedLayers::kSize;
constexpr int kMiddle = kSize.x / 2; // the column on A's edge: half of its kernel is A

/// Cantelli's bound on the light at a point of `c` whose kernel holds `a` to the share p, and else `b`: depths, or what became
/// of them.
double bound(double p, double a, double b, double c) {
    const double mean = p * a + (1 - p) * b, variance = p * (1 - p) * (a - b) * (a - b);
    return c <= mean ? 1 : variance / (variance + (c - mean) * (c - mean));
}

// C is completely behind B, and should be black. The tolerance is the criterion for a picture; what is measured is a hundred
// times less, of float numbers and the sampler's weights.
constexpr double kTolerance = 0.005;

const std::map<double, double> kLightAtHalf = { // a : b, and (a^2/4) / (a^2/4 + (a/2 + b)^2)
    {1, 0.1000},
    {2, 0.2000},
    {4, 0.3077},
    {10, 0.4098},
    {100, 0.4901}};

TEST_F(BleedingTest, VarianceLetsThroughWhatTheClosedFormSays) {
    ShadowMapSlot slot(nullptr);
    for (const auto& [ratio, atHalf] : kLightAtHalf) {
        const double a = 2, b = a / ratio;
        const StackedLayers stack = testing::layers({.a = a, .b = b});
        slot.setScene(testing::snapshot(stack.scene()));
        const LightShares shares = slot.shares(bare("vsm"), kSize);
        const Deviation found =
            deviation(shares, stack, [&](double p) { return bound(p, 0, a, a + b); }); // metres from A
        std::cout << "a:b = " << ratio << ": " << shares.at(kMiddle, kMiddle) << " at p = 1/2, from the closed form "
                  << found.largest << "\n";
        EXPECT_GT(found.mixed, 7000);
        EXPECT_LE(found.largest, kTolerance) << ratio;
        EXPECT_NEAR(shares.at(kMiddle, kMiddle), atHalf, kTolerance) << ratio;
        EXPECT_EQ(stack.share(kMiddle), 0.5);
    }
}

/// Of all light that a picture shows, the mean.
double meanOf(const LightShares& shares) {
    double sum = 0;
    for (const float share : shares.values)
        sum += share;
    return sum / static_cast<double>(shares.values.size());
}

TEST_F(BleedingTest, EveryRemedyLetsLessThrough) {
    ShadowMapSlot slot(nullptr);
    for (const double ratio : {1.0, 4.0, 100.0}) {
        const double a = 2, b = a / ratio;
        const StackedLayers stack = testing::layers({.a = a, .b = b});
        slot.setScene(testing::snapshot(stack.scene()));
        const auto mean = [&](const std::string& filter, const std::vector<std::string>& more = {}) {
            return meanOf(slot.shares(bare(filter, more), kSize));
        };
        const double vsm = mean("vsm"), reduced = mean("vsm", {"bleed-reduction=0.1"}),
                     reducedMore = mean("vsm", {"bleed-reduction=0.5"}), evsm2 = mean("evsm", {"evsm-moments=2"}),
                     evsm4 = mean("evsm", {"evsm-moments=4"}), msm = mean("msm");
        std::cout << "a:b = " << ratio << ": vsm " << vsm << ", reduced " << reduced << ", more " << reducedMore
                  << ", evsm " << evsm2 << ", of four " << evsm4 << ", msm " << msm << "\n";
        EXPECT_GT(vsm, 0.05);
        EXPECT_LT(reduced, vsm);
        EXPECT_LT(reducedMore, reduced);
        EXPECT_LT(evsm2, 0.5 * vsm);
        EXPECT_LE(evsm4, evsm2);
        EXPECT_LT(msm, kTolerance) << "four moments tell both depths";
        const Deviation exponential =
            deviation(slot.shares(bare("evsm", {"evsm-moments=2", "evsm-exponent=10"}), kSize), stack, [&](double p) {
                const auto warped = [&](double height) { return std::exp(10 * stack.momentDepthOf(height)); };
                return bound(p, warped(a + b), warped(b), warped(0));
            });
        EXPECT_LE(exponential.largest, kTolerance) << "evsm is vsm of warped depths";
    }
}

// Exponentials are averaged, also where only their logarithms are kept; behind A and B what they leave of the light is
// exp(-c times the distance), close behind B nearly all.
TEST_F(BleedingTest, AnExponentialMapIsTheMeanOfTwoExponentials) {
    for (const auto& [a, b, seesB] : {std::tuple{2.0, 0.02, false}, {2.0, 0.5, false}, {0.5, 2.0, true}}) {
        const StackedLayers stack = testing::layers({.a = a, .b = b, .seesB = seesB});
        ShadowMapSlot slot(testing::snapshot(stack.scene()));
        const double bHeight = seesB ? 0 : b;
        for (const double exponent : {5.0, 40.0})
            for (const char* logarithms : {"esm-logarithms=true", "esm-logarithms=false"}) {
                const auto left = [&](double height) { // z from 0 to 1 is half as wide as from -1 to 1
                    return std::exp(0.5 * exponent * (stack.momentDepthOf(height) - stack.momentDepthOf(0)));
                };
                const Deviation found =
                    deviation(slot.shares(bare("esm", {"esm-exponent=" + std::to_string(exponent), logarithms}), kSize),
                              stack, [&](double p) { return p * left(bHeight + a) + (1 - p) * left(bHeight); });
                std::cout << "esm, a:b = " << a / b << ", c = " << exponent << ": " << found.largest << "\n";
                EXPECT_GT(found.mixed, 7000);
                EXPECT_LE(found.largest, kTolerance) << a / b << " " << exponent << " " << logarithms;
            }
    }
}

// Around the place where the edges of A and B cross a kernel holds all three. What the filters find is a bound: never less than
// the light there is, which is the share of C in the kernel; and four moments bound it more tightly than the two among them.
TEST_F(BleedingTest, NoBoundIsBelowTheLightAndMomentsAreTheTighterOne) {
    constexpr double kRounding = 1e-3;
    for (const double ratio : {1.0, 4.0, 10.0}) { // b : 2 m much smaller than that is not far above msm-bias
        const double a = 2, b = a / ratio;
        const StackedLayers stack = testing::layers({.a = a, .b = b, .bEndsAtEdge = true});
        ShadowMapSlot slot(testing::snapshot(stack.scene()));
        const LightShares vsm = slot.shares(bare("vsm"), kSize), msm = slot.shares(bare("msm"), kSize),
                          evsm = slot.shares(bare("evsm"), kSize);
        int three = 0, brighter = 0;
        double excess = -1, lack = -1;
        for (int y = 0; y < kSize.y; ++y)
            for (int x = 0; x < kSize.x; ++x) {
                const double light = (1 - stack.share(x)) * (1 - stack.share(y));
                three += light > 0.01 && stack.share(x) > 0.01 && stack.share(y) > 0.01;
                excess = std::max<double>(excess, msm.at(x, y) - vsm.at(x, y));
                for (const LightShares* shares : {&vsm, &msm, &evsm})
                    lack = std::max(lack, light - asNumber(shares->at(x, y)));
                brighter += vsm.at(x, y) > light + 0.05;
            }
        std::cout << "a:b = " << ratio << ": msm - vsm <= " << excess << ", light - bound <= " << lack << ", means "
                  << meanOf(vsm) << " " << meanOf(evsm) << " " << meanOf(msm) << "\n";
        EXPECT_GT(three, 5000);
        EXPECT_GT(brighter, 1000) << "vsm is too bright in many places, or this says nothing";
        EXPECT_LE(excess, kRounding) << ratio;
        EXPECT_LE(lack, kRounding) << ratio;
        EXPECT_LT(meanOf(msm), meanOf(vsm) - 0.01);
    }
}

} // namespace
} // namespace shadowlab
