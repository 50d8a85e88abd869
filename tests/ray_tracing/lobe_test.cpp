// Lobes: how directions are spread, held against what is known in closed form.
// SPDX-License-Identifier: MIT
#include "techniques/ray_tracing/sampling/lobe.h"

#include <cmath>
#include <vector>

#include <glm/gtc/constants.hpp>
#include <gtest/gtest.h>

#include "techniques/ray_tracing/sampling/sample_numbers.h"

namespace shadowlab::ray_tracing {
namespace {

constexpr int kDraws = 100000;

dvec2 draw(int i) {
    return SampleNumbers({kDraws, SamplePattern::Spread::random, 1, 5}, {0, 0}, static_cast<std::uint32_t>(i))
        .pair(Purpose::reflection);
}

TEST(Lobe, HalfIsLeftAtTheGivenAngle) {
    for (const double degrees : {0.1, 1.0, 10.0, 45.0, 60.0, 80.0})
        EXPECT_NEAR(std::pow(std::cos(glm::radians(degrees)), lobePower(degrees)), 0.5, 1e-9) << degrees;
    EXPECT_NEAR(lobePower(60), 1, 1e-12); // Lambert's law
    EXPECT_EQ(lobePower(90), 0);
}

TEST(Lobe, AnglesToTheAxisAreDistributedAsThePowerSays) {
    const dvec3 axis = glm::normalize(dvec3(0.3, -0.8, 0.5));
    for (const double power : {0.0, 1.0, 5.0, 200.0}) {
        // cos^(n + 1) of a direction is evenly distributed: 20 bins, 19 degrees of freedom.
        std::vector<double> bins(20, 0);
        dvec3 sum(0.0);
        for (int i = 0; i < kDraws; ++i) {
            const dvec3 direction = lobeDirection(axis, power, draw(i));
            ASSERT_NEAR(glm::length(direction), 1, 1e-12);
            sum += direction;
            const double even = std::pow(std::max(0.0, glm::dot(direction, axis)), power + 1);
            ++bins[static_cast<std::size_t>(std::min(19.0, even * 20))];
        }
        double chi2 = 0;
        for (const double count : bins)
            chi2 += (count - kDraws / 20.0) * (count - kDraws / 20.0) / (kDraws / 20.0);
        EXPECT_LT(chi2, 43.8) << power; // one in a thousand
        // The mean points along the axis, and is (n + 1) / (n + 2) long; no direction varies by more than 1.
        const dvec3 mean = sum / static_cast<double>(kDraws);
        EXPECT_LT(glm::length(mean - (power + 1) / (power + 2) * axis), 4 / std::sqrt(kDraws)) << power;
    }
}

/// Share of a lobe on one side of a plane.
double shareAbove(const dvec3& axis, double power, const dvec3& normal) {
    int above = 0;
    for (int i = 0; i < kDraws; ++i)
        above += glm::dot(lobeDirection(axis, power, draw(i)), normal) > 0 ? 1 : 0;
    return static_cast<double>(above) / kDraws;
}

TEST(Lobe, APlaneCutsOffWhatIsKnown) {
    const dvec3 normal(0, 1, 0);
    // Four standard deviations of a share.
    const auto bound = [](double share) { return 4 * std::sqrt(share * (1 - share) / kDraws) + 1e-12; };
    for (const double power : {1.0, 4.0, 50.0}) // a plane through the axis: one half, whatever the power
        EXPECT_NEAR(shareAbove({1, 0, 0}, power, normal), 0.5, bound(0.5)) << power;
    for (const double tiltDegrees : {0.0, 20.0, 45.0, 70.0, 90.0}) { // Lambert's lobe, tilted: (1 + cos) / 2
        const double tilt = glm::radians(tiltDegrees), expected = (1 + std::cos(tilt)) / 2;
        EXPECT_NEAR(shareAbove({std::sin(tilt), std::cos(tilt), 0}, 1, normal), expected, bound(expected));
    }
}

TEST(Lobe, ADiscIsFilledEvenly) {
    // Rings and sectors of equal area; and the part on one side of a line at half the radius.
    std::vector<double> bins(40, 0);
    int beside = 0;
    for (int i = 0; i < kDraws; ++i) {
        const dvec2 p = onDisc(draw(i));
        const double r2 = glm::dot(p, p);
        ASSERT_LE(r2, 1 + 1e-12);
        const double turn = std::atan2(p.y, p.x) / glm::two_pi<double>() + 0.5;
        ++bins[static_cast<std::size_t>(std::min(4.0, r2 * 5) * 8) / 8 * 8 +
               static_cast<std::size_t>(std::min(7.0, turn * 8))];
        beside += p.x < 0.5 ? 1 : 0;
    }
    double chi2 = 0;
    for (const double count : bins)
        chi2 += (count - kDraws / 40.0) * (count - kDraws / 40.0) / (kDraws / 40.0);
    EXPECT_LT(chi2, 72.1); // 39 degrees of freedom, one in a thousand
    const double expected = 0.5 + (0.5 * std::sqrt(0.75) + std::asin(0.5)) / glm::pi<double>();
    EXPECT_NEAR(expected, 0.80449889, 1e-8);
    EXPECT_NEAR(beside / static_cast<double>(kDraws), expected, 4 * std::sqrt(expected * (1 - expected) / kDraws));
    // Neighbours stay neighbours, also across the diagonals where the two formulas meet.
    for (int i = 0; i < 1000; ++i) {
        const double at = i / 1000.0;
        EXPECT_LT(glm::length(onDisc({at, at + 1e-9}) - onDisc({at + 1e-9, at})), 1e-8);
    }
}

} // namespace
} // namespace shadowlab::ray_tracing
