// Exchange areas: reciprocity by construction, row sums, and what scaling them changes.
// SPDX-License-Identifier: MIT
#include "techniques/radiosity/exchange/exchange_matrix.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "tests/radiosity/rooms.h"

namespace shadowlab::radiosity {
namespace {

/// A room of n patches of different areas, all in view of each other: closed, but for form factors that are off by up to `error`.
testing::Room roomWithErrors(std::size_t n, double error, std::uint64_t seed) {
    std::mt19937_64 numbers(seed);
    std::uniform_real_distribution<double> unit(0, 1);
    std::vector<double> areas;
    for (std::size_t i = 0; i < n; ++i)
        areas.push_back(0.1 + unit(numbers));
    testing::Room room = testing::sphereInside(areas, std::vector(n, dvec3(1)), std::vector(n, dvec3(0.5)));
    for (std::size_t i = 0; i < n; ++i)
        for (std::size_t j = 0; j <= i; ++j)
            room.exchange.set(i, j, room.exchange(i, j) * (1 + error * (2 * unit(numbers) - 1)));
    return room;
}

bool isSymmetric(const ExchangeMatrix& exchange) {
    for (std::size_t i = 0; i < exchange.size(); ++i)
        for (std::size_t j = 0; j < i; ++j)
            if (exchange(i, j) != exchange(j, i)) return false;
    return true;
}

TEST(ExchangeMatrix, KeepsOneNumberForBothDirections) {
    ExchangeMatrix exchange(3);
    exchange.set(0, 2, 0.25);
    exchange.set(1, 1, 0.5);
    EXPECT_EQ(exchange(2, 0), 0.25);
    EXPECT_EQ(exchange(0, 2), 0.25);
    EXPECT_EQ(exchange(0, 1), 0);
    EXPECT_EQ(exchange.row(2)[0], 0.25);
    EXPECT_EQ(exchange.row(1).size(), 3u);
    EXPECT_EQ(exchange.bytes(), 9 * sizeof(double));
    const std::vector<double> areas = {1, 2, 0.5};
    EXPECT_EQ(rowSums(exchange, areas), (std::vector<double>{0.25, 0.25, 0.5}));
    EXPECT_EQ(closureDeficits(exchange, areas), (std::vector<double>{0.75, 0.75, 0.5}));
}

TEST(ExchangeMatrix, IsReciprocalByConstructionAndFormFactorsOnTheirOwnAreNot) {
    const testing::Room room = roomWithErrors(40, 0.3, 1);
    // F is rounded twice on the way there and twice on the way back.
    EXPECT_LE(reciprocityResidual(room.exchange, room.areas), 4.5e-16);
    EXPECT_GT(reciprocityResidual(room.exchange, room.areas), 0) << "that nothing was rounded is not to be believed";

    // Row by row, as naive programs bring sums to 1: F_ij / sum_j F_ij. The sums are right and the pairs no longer fit.
    const std::vector<double> sums = rowSums(room.exchange, room.areas);
    double naive = 0;
    for (std::size_t i = 0; i < room.size(); ++i)
        for (std::size_t j = 0; j < i; ++j) {
            const double there = room.exchange(i, j) / sums[i], back = room.exchange(j, i) / sums[j];
            naive = std::max(naive, std::abs(there - back) / std::max(there, back));
        }
    EXPECT_GT(naive, 1e-2);
}

TEST(ScaledToClosure, ClosesARoomKeepsItReciprocalAndSaysWhatItChanged) {
    int rooms = 0;
    for (const double error : {1e-9, 1e-4, 0.02, 0.5})
        for (const std::size_t n : {2, 3, 17, 300}) {
            const testing::Room room = roomWithErrors(n, error, n);
            const ScaledExchange scaled = scaledToClosure(room.exchange, room.areas, Closure::closedRoom);
            ASSERT_TRUE(scaled.isClosed) << n;
            double deviation = 0, change = 0;
            for (const double sum : rowSums(scaled.exchange, room.areas))
                deviation = std::max(deviation, std::abs(sum - 1));
            // Asked for is 1e-6; 1e-12 is where it stops, and n roundings come on top.
            EXPECT_LE(deviation, 1e-12 + 1e-16 * static_cast<double>(n)) << n;
            EXPECT_NEAR(scaled.largestDeviation, deviation, 1e-15 * static_cast<double>(n));
            EXPECT_TRUE(isSymmetric(scaled.exchange));
            EXPECT_LE(reciprocityResidual(scaled.exchange, room.areas), 1e-12);
            for (std::size_t i = 0; i < n; ++i)
                for (std::size_t j = 0; j < n; ++j)
                    change = std::max(change, std::abs(scaled.exchange(i, j) / room.exchange(i, j) - 1));
            EXPECT_NEAR(scaled.largestChange, change, 1e-14);
            EXPECT_GT(change, 0.05 * error) << "what was wrong has to be seen";
            EXPECT_LT(change, 3 * error) << "and nothing else is changed";
            ++rooms;
        }
    EXPECT_EQ(rooms, 16);
}

// What a program does that makes each row sum to one on its own: A_i F_ij is not A_j F_ji any more.
TEST(ScaledToClosure, RowsScaledOneByOneAreNotReciprocal) {
    constexpr double kError = 0.02;
    const testing::Room room = roomWithErrors(17, kError, 1);
    const std::vector<double> sums = rowSums(room.exchange, room.areas);
    double most = 0;
    for (std::size_t i = 0; i < room.areas.size(); ++i)
        for (std::size_t j = 0; j < i; ++j)
            most = std::max(most, std::abs(sums[j] / sums[i] - 1)); // S_ij / sum_i beside S_ij / sum_j
    EXPECT_GT(most, 0.1 * kError);
    const ScaledExchange scaled = scaledToClosure(room.exchange, room.areas, Closure::closedRoom);
    EXPECT_LE(reciprocityResidual(scaled.exchange, room.areas), 1e-12);
}

TEST(ScaledToClosure, LeavesAloneWhatIsRight) {
    const testing::Room cube = testing::cube(.5, .5, .5);
    const ScaledExchange scaled = scaledToClosure(cube.exchange, cube.areas, Closure::closedRoom);
    EXPECT_TRUE(scaled.isClosed);
    EXPECT_EQ(scaled.passes, 0);
    EXPECT_EQ(scaled.largestChange, 0);
    EXPECT_EQ(scaled.exchange(0, 1), testing::oppositeInCube());
}

TEST(ScaledToClosure, GivesBackAsItWasWhatCannotBeClosed) {
    // A patch that sees nothing; and a small one that is all that a large one sees.
    testing::Room blind = roomWithErrors(5, 0.1, 3);
    for (std::size_t j = 0; j < 5; ++j)
        blind.exchange.set(2, j, 0);
    ExchangeMatrix two(2);
    two.set(0, 1, 0.5);
    const std::vector<double> unequal = {1, 3};
    const ScaledExchange first = scaledToClosure(blind.exchange, blind.areas, Closure::closedRoom);
    const ScaledExchange second = scaledToClosure(two, unequal, Closure::closedRoom);
    EXPECT_FALSE(first.isClosed);
    EXPECT_FALSE(second.isClosed);
    EXPECT_EQ(first.largestDeviation, 1) << "the blind patch";
    EXPECT_EQ(second.largestChange, 0);
    EXPECT_EQ(second.exchange(0, 1), 0.5);
    for (std::size_t i = 0; i < 5; ++i)
        for (std::size_t j = 0; j < 5; ++j)
            EXPECT_EQ(first.exchange(i, j), blind.exchange(i, j));
}

TEST(ScaledToClosure, InAnOpenSceneNothingGrows) {
    int tooLarge = 0, open = 0;
    for (std::uint64_t seed = 1; seed <= 100; ++seed) {
        testing::Room room = roomWithErrors(12, 0.5, seed);
        for (std::size_t i = 0; i < 12; ++i)
            room.exchange.set(i, 0, 0.2 * room.exchange(i, 0)); // one patch sees the sky
        const std::vector<double> before = rowSums(room.exchange, room.areas);
        const ScaledExchange scaled = scaledToClosure(room.exchange, room.areas, Closure::openScene);
        const std::vector<double> after = rowSums(scaled.exchange, room.areas);
        EXPECT_TRUE(scaled.isClosed);
        EXPECT_TRUE(isSymmetric(scaled.exchange));
        for (std::size_t i = 0; i < 12; ++i) {
            EXPECT_LE(after[i], 1 + 1e-14); // 12 roundings
            tooLarge += before[i] > 1;
            open += after[i] < 0.8;
            for (std::size_t j = 0; j < 12; ++j) {
                EXPECT_LE(scaled.exchange(i, j), room.exchange(i, j));
                if (before[i] <= 1 && before[j] <= 1) {
                    EXPECT_EQ(scaled.exchange(i, j), room.exchange(i, j));
                }
            }
        }
    }
    EXPECT_GT(tooLarge, 100);
    EXPECT_GT(open, 90);
}

} // namespace
} // namespace shadowlab::radiosity
