// Reflection and refraction at one smooth surface, against values worked out with more digits.
// SPDX-License-Identifier: MIT
#include "techniques/ray_tracing/tree/fresnel.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <utility>

#include <glm/gtc/constants.hpp>

namespace shadowlab::ray_tracing {
namespace {

constexpr double kGlass = 1.5;
const dvec3 kUp(0, 1, 0);

double radians(double degrees) { return degrees * glm::pi<double>() / 180; }

/// Downward, that many degrees away from straight down.
dvec3 downward(double degrees) { return {std::sin(radians(degrees)), -std::cos(radians(degrees)), 0}; }

/// The share that goes through, by formulas of its own: the amplitudes of the refracted wave, and the width of its beam.
double transmittance(double degrees, double ratio) {
    const double in = std::cos(radians(degrees));
    const double out = std::sqrt(1 - std::pow(ratio * std::sin(radians(degrees)), 2));
    const double across = 2 * ratio * in / (ratio * in + out), along = 2 * ratio * in / (in + ratio * out);
    return out / (ratio * in) * 0.5 * (across * across + along * along);
}

TEST(Fresnel, FromAirToGlass) {
    // Given to six digits.
    const std::array<std::pair<double, double>, 7> table = {
        {{0, .04}, {30, .041523}, {45, .050240}, {60, .089187}, {75, .253061}, {85, .612800}, {89, .904185}}};
    for (const auto& [degrees, share] : table)
        EXPECT_NEAR(fresnelReflectance(std::cos(radians(degrees)), 1 / kGlass), share, 1e-6) << degrees;
}

TEST(Fresnel, FromGlassToAirUpToTotalReflection) {
    const std::array<std::pair<double, double>, 5> table = {
        {{40, .245291}, {41, .379751}, {41.8, .890772}, {41.82, 1}, {80, 1}}};
    for (const auto& [degrees, share] : table) {
        EXPECT_NEAR(fresnelReflectance(std::cos(radians(degrees)), kGlass), share, 1e-6) << degrees;
        EXPECT_EQ(refracted(downward(degrees), kUp, kGlass).has_value(), share < 1) << degrees;
    }
}

TEST(Fresnel, NothingIsLostAndNothingIsNotANumber) {
    int total = 0, shared = 0;
    for (const double ratio : {1 / kGlass, kGlass, 1 / 1.33, 1.33, 1.33 / kGlass, 2.4, 10.0, 0.1})
        for (int i = 0; i < 9000; ++i) { // up to a hundredth of a degree from grazing, through every critical angle
            const double degrees = 0.01 * i;
            const dvec3 u = downward(degrees);
            const double share = fresnelReflectance(-u.y, ratio);
            ASSERT_TRUE(share >= 0 && share <= 1) << degrees;
            const auto bent = refracted(u, kUp, ratio);
            ASSERT_NEAR(glm::length(reflected(u, kUp)), 1, 1e-12);
            if (!bent) {
                ASSERT_EQ(share, 1) << degrees;
                ++total;
                continue;
            }
            ASSERT_NEAR(glm::length(*bent), 1, 1e-12);
            ASSERT_NEAR(bent->x, ratio * u.x, 1e-12) << "not as Snell's law wants it";
            // A millionth above the critical angle the square root in the formulas loses half of its digits.
            if (1 - std::pow(ratio * u.x, 2) < 1e-6) continue;
            ASSERT_NEAR(share + transmittance(degrees, ratio), 1, 1e-12) << degrees;
            ++shared;
        }
    EXPECT_GT(total, 10'000);
    EXPECT_GT(shared, 30'000);
}

// Without a look at the sign under the root there is no number at all: the checks above would see it.
TEST(Fresnel, WithoutAskingForTotalReflectionThereIsNoNumber) {
    const dvec3 u = downward(41.82);
    const double cosIncident = -u.y;
    const dvec3 naive =
        kGlass * u + (kGlass * cosIncident - std::sqrt(1 - kGlass * kGlass * (1 - cosIncident * cosIncident))) * kUp;
    EXPECT_TRUE(std::isnan(naive.y));
}

TEST(Fresnel, AtTheCriticalAngleAndAtNormalAndGrazingIncidence) {
    const double critical = std::asin(1 / kGlass);
    for (const double off : {-1e-9, -1e-15, 0.0, 1e-15, 1e-9}) {
        const double share = fresnelReflectance(std::cos(critical + off), kGlass);
        EXPECT_TRUE(share > 0.999 && share <= 1) << off; // it gets there with an infinite slope
    }
    EXPECT_DOUBLE_EQ(fresnelReflectance(1, kGlass), 0.04);
    EXPECT_EQ(fresnelReflectance(0, 1 / kGlass), 1);
    EXPECT_EQ(fresnelReflectance(0.3, 1), 0) << "the same medium on both sides";
    EXPECT_EQ(*refracted(downward(77), kUp, 1), downward(77));
    EXPECT_EQ(*refracted(downward(0), kUp, kGlass), downward(0));
}

TEST(Fresnel, SchlicksPolynomialIsNearAndNotTheSame) {
    const std::array<std::pair<double, double>, 6> table = {
        {{0, .0400}, {45, .0421}, {60, .0700}, {75, .2547}, {85, .6485}, {89, .9191}}};
    for (const auto& [degrees, share] : table) // given to four digits
        EXPECT_NEAR(schlickReflectance(std::cos(radians(degrees)), 1 / kGlass), share, 5.1e-5) << degrees;
    // From within it is asked with the angle outside: equal there and back.
    const double outside = std::asin(kGlass * std::sin(radians(30)));
    EXPECT_NEAR(schlickReflectance(std::cos(radians(30)), kGlass), schlickReflectance(std::cos(outside), 1 / kGlass),
                1e-12);
    EXPECT_EQ(schlickReflectance(std::cos(radians(50)), kGlass), 1);
}

TEST(Fresnel, WeightsShareOutWhatTheMaterialGives) {
    const double cosIncident = std::cos(radians(60)), share = fresnelReflectance(cosIncident, 1 / kGlass);
    const Weights exact = weightsOf(0.1, 0.8, cosIncident, 1 / kGlass, Fresnel::exact);
    EXPECT_NEAR(exact.reflected, 0.9 * share, 1e-15);
    EXPECT_NEAR(exact.transmitted, 0.9 * (1 - share), 1e-15);
    const Weights constant = weightsOf(0.1, 0.8, cosIncident, 1 / kGlass, Fresnel::constant);
    EXPECT_EQ(constant.reflected, 0.1);
    EXPECT_EQ(constant.transmitted, 0.8);
    for (const Fresnel kind : {Fresnel::exact, Fresnel::schlick, Fresnel::constant}) {
        const Weights metal = weightsOf(0.7, 0, cosIncident, 1 / kGlass, kind);
        EXPECT_EQ(metal.reflected, 0.7);
        EXPECT_EQ(metal.transmitted, 0);
        const Weights total = weightsOf(0.1, 0.8, cosIncident, kGlass, kind);
        EXPECT_TRUE(total.isTotal);
        EXPECT_NEAR(total.reflected, 0.9, 1e-15);
        EXPECT_EQ(total.transmitted, 0);
    }
}

/// A ray through a ball whose surface is a ball's and no mesh: the angle by which it is turned.
double deviationDegrees(double inward, double outward) {
    const dvec3 u(1, 0, 0);
    const dvec3 enters(-std::sqrt(0.5), std::sqrt(0.5), 0); // at 45 degrees
    const dvec3 within = *refracted(u, enters, inward);
    const dvec3 leaves = enters - 2 * glm::dot(enters, within) * within;
    const auto out = refracted(within, -leaves, outward);
    return out ? std::acos(glm::dot(u, *out)) / radians(1) : -1;
}

TEST(Fresnel, ABallOfGlassTurnsARay) {
    EXPECT_NEAR(deviationDegrees(1 / kGlass, kGlass), 33.7489886, 5e-8); // given to seven decimals
    const double closedForm = 2 * (45 - std::asin(std::sin(radians(45)) / kGlass) / radians(1));
    EXPECT_NEAR(deviationDegrees(1 / kGlass, kGlass), closedForm, 1e-9);
    // With the same ratio on both sides, the classical slip, it never comes out where it should.
    EXPECT_GT(std::abs(deviationDegrees(1 / kGlass, 1 / kGlass) - closedForm), 1);
}

} // namespace
} // namespace shadowlab::ray_tracing
