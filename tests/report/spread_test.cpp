// Medians, their intervals, and powers, against numbers worked out by hand or in closed form.
// SPDX-License-Identifier: MIT
#include "app/report/spread.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <random>

namespace shadowlab::report {
namespace {

std::vector<double> upTo(int n) {
    std::vector<double> values(static_cast<std::size_t>(n));
    std::iota(values.begin(), values.end(), 1.0);
    return values;
}

TEST(Spread, OfThirtyValues) {
    // Of 30 tosses of a coin fewer than 10 are heads with 2.14 %, fewer than 11 with 4.94 %: the 10th from either end.
    const Spread spread = spreadOf(upTo(30));
    EXPECT_EQ(spread.median, 15.5);
    EXPECT_EQ(spread.lower, 10);
    EXPECT_EQ(spread.upper, 21);
    EXPECT_EQ(spread.p95, 29);
}

TEST(Spread, OfFewValuesIsAllOfThem) {
    EXPECT_EQ(spreadOf({}).median, 0);
    const Spread one = spreadOf({7});
    EXPECT_EQ(one.lower, 7);
    EXPECT_EQ(one.upper, 7);
    // Of six values all lie on one side with 2 / 64 = 3.1 %: the least and the largest are 97 % sure.
    const Spread six = spreadOf({6, 1, 5, 2, 4, 3});
    EXPECT_EQ(six.lower, 1);
    EXPECT_EQ(six.upper, 6);
    EXPECT_EQ(six.median, 3.5);
}

TEST(Spread, HoldsTheMedianAsOftenAsItSays) {
    std::mt19937_64 random(1);
    std::exponential_distribution<double> skew(1);
    const double trueMedian = std::log(2.0);
    int held = 0;
    constexpr int kTimes = 4000;
    for (int i = 0; i < kTimes; ++i) {
        std::vector<double> values(35);
        for (double& value : values)
            value = skew(random);
        const Spread spread = spreadOf(values);
        held += spread.lower <= trueMedian && trueMedian <= spread.upper;
    }
    // P(12 <= heads of 35 <= 23) = 95.9 %, give or take four deviations of 4000 trials, 1.3 %. A rank too far in would be 90 %.
    EXPECT_NEAR(static_cast<double>(held) / kTimes, 0.959, 0.013);
}

TEST(Spread, OfManyValuesDoesNotUnderflow) {
    const Spread spread = spreadOf(upTo(5001));
    EXPECT_EQ(spread.median, 2501);
    // The normal approximation: n/2 - 1.96 sqrt(n)/2 is 2431.2.
    EXPECT_NEAR(spread.lower, 2431, 2);
    EXPECT_NEAR(spread.upper, 2571, 2);
}

TEST(Power, IsThatOfThePoints) {
    const std::vector<double> x{256, 512, 1024, 2048};
    std::vector<double> y;
    for (const double value : x)
        y.push_back(3 * std::pow(value, -1.25));
    ASSERT_TRUE(powerOf(x, y));
    EXPECT_NEAR(*powerOf(x, y), -1.25, 1e-12); // rounding alone
}

TEST(Power, LeavesOutWhatHasNoLogarithm) {
    EXPECT_NEAR(*powerOf(std::vector<double>{1, 2, 4}, std::vector<double>{0, 4, 16}), 2, 1e-12);
    EXPECT_FALSE(powerOf(std::vector<double>{1, 2, 4}, std::vector<double>{0, 0, 5}));
    EXPECT_FALSE(powerOf(std::vector<double>{2, 2}, std::vector<double>{1, 5}));
    EXPECT_FALSE(powerOf(std::vector<double>{}, std::vector<double>{}));
}

} // namespace
} // namespace shadowlab::report
