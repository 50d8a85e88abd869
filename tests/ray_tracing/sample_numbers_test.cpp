// The numbers that chance gives: every cell once, no dimension knows of another, and errors fall as they must.
// SPDX-License-Identifier: MIT
#include "techniques/ray_tracing/sampling/sample_numbers.h"

#include <algorithm>
#include <set>

#include <gtest/gtest.h>

#include "tests/support/half_plane.h"

namespace shadowlab::ray_tracing {
namespace {

using enum SamplePattern::Spread;

std::vector<dvec2> pairsOf(const SamplePattern& pattern, ivec2 pixel, Purpose purpose, std::uint64_t place = 0) {
    std::vector<dvec2> pairs;
    for (int sample = 0; sample < pattern.count; ++sample)
        pairs.push_back(SampleNumbers(pattern, pixel, static_cast<std::uint32_t>(sample)).pair(purpose, place));
    return pairs;
}

/// How many of as many cells of a square hold a point.
std::size_t cellsMet(const std::vector<dvec2>& points, int columns, int rows) {
    std::set<int> met;
    for (const dvec2& p : points)
        met.insert(static_cast<int>(p.x * columns) + columns * static_cast<int>(p.y * rows));
    return met.size();
}

TEST(SampleNumbers, JitteredMeetsEveryCellOnce) {
    int compared = 0;
    for (const int side : {1, 2, 3, 4, 5, 8, 12})
        for (int pixel = 0; pixel < 40; ++pixel)
            for (const double jitter : {1.0, 0.3, 0.0}) {
                const SamplePattern pattern{side * side, jittered, jitter, 7};
                const auto points = pairsOf(pattern, {pixel, 3 * pixel}, Purpose::light, 5);
                EXPECT_EQ(cellsMet(points, side, side), points.size()) << side << " " << pixel;
                ++compared;
            }
    EXPECT_EQ(compared, 7 * 40 * 3);
    // By chance alone a third of the cells stays empty: 1/e.
    EXPECT_LT(cellsMet(pairsOf({144, random, 1, 7}, {1, 1}, Purpose::light), 12, 12), 110u);
}

TEST(SampleNumbers, AnyCountFillsEqualCells) {
    // Not a square: in rows that differ by one cell at most. Times have one cell each on a line.
    for (const int count : {2, 3, 7, 11, 30, 101}) {
        std::set<int> cells;
        std::vector<double> heights;
        for (int sample = 0; sample < count; ++sample) {
            const SampleNumbers numbers({count, jittered, 1, 0}, {9, 4}, static_cast<std::uint32_t>(sample));
            cells.insert(static_cast<int>(numbers.one(Purpose::time) * count));
            heights.push_back(numbers.pair(Purpose::lens).y);
        }
        EXPECT_EQ(cells.size(), static_cast<std::size_t>(count));
        std::ranges::sort(heights);
        // In a row of n cells heights lie in a band n / count high, so the k-th lowest is near its share.
        for (int i = 0; i < count; ++i)
            EXPECT_NEAR(heights[static_cast<std::size_t>(i)], (i + 0.5) / count, 1.5 / std::sqrt(count) + 1.0 / count);
    }
}

TEST(SampleNumbers, RegularIsTheSameInEveryPixel) {
    EXPECT_EQ(pairsOf({16, regular, 1, 0}, {0, 0}, Purpose::lens),
              pairsOf({16, regular, 1, 0}, {81, 17}, Purpose::lens));
    EXPECT_NE(pairsOf({16, jittered, 1, 0}, {0, 0}, Purpose::lens),
              pairsOf({16, jittered, 1, 0}, {81, 17}, Purpose::lens));
    for (const dvec2& p : pairsOf({16, regular, 1, 0}, {3, 3}, Purpose::pixel)) { // middles of cells
        EXPECT_EQ(glm::fract(p.x * 4), 0.5);
        EXPECT_EQ(glm::fract(p.y * 4), 0.5);
    }
}

/// Correlation of the first numbers of two dimensions over all samples of many pixels.
double correlation(const SamplePattern& pattern, Purpose a, std::uint64_t placeA, Purpose b, std::uint64_t placeB) {
    double sum = 0, n = 0;
    for (int pixel = 0; pixel < 2000; ++pixel) {
        const auto first = pairsOf(pattern, {pixel, 0}, a, placeA), second = pairsOf(pattern, {pixel, 0}, b, placeB);
        for (std::size_t i = 0; i < first.size(); ++i, ++n)
            sum += 12 * (first[i].x - 0.5) * (second[i].x - 0.5); // 1/12 is the variance of a number in [0, 1)
    }
    return sum / n;
}

TEST(SampleNumbers, DimensionsDoNotKnowOfEachOther) {
    for (const auto spread : {jittered, random, lowDiscrepancy}) {
        const SamplePattern pattern{16, spread, 1, 0};
        // 32,000 pairs: the standard deviation of the correlation is at most 1/179.
        EXPECT_LT(std::abs(correlation(pattern, Purpose::pixel, 0, Purpose::light, 1)), 4.0 / 179);
        EXPECT_LT(std::abs(correlation(pattern, Purpose::light, 1, Purpose::light, 2)), 4.0 / 179);
        EXPECT_LT(std::abs(correlation(pattern, Purpose::lens, 0, Purpose::time, 0)), 4.0 / 179);
        // The fault that is looked for: one dimension for both, and the left of the pixel sees the left of the lamp.
        EXPECT_GT(correlation(pattern, Purpose::light, 1, Purpose::light, 1), 0.9);
    }
}

TEST(SampleNumbers, EveryPowerOfTwoOfEvenPointsFillsAllBoxesOfItsArea) {
    // A (0, m, 2)-net: of 2^m points one lies in each box of 2^-k x 2^-(m - k). Owen's scrambling keeps that.
    int boxes = 0;
    for (int pixel = 0; pixel < 25; ++pixel)
        for (int m = 0; m <= 8; ++m) {
            const auto points = pairsOf({1 << m, lowDiscrepancy, 1, 3}, {pixel, 11}, Purpose::light, 2);
            for (int k = 0; k <= m; ++k, ++boxes)
                EXPECT_EQ(cellsMet(points, 1 << k, 1 << (m - k)), points.size()) << pixel << " " << m << " " << k;
        }
    EXPECT_EQ(boxes, 25 * 45);
}

TEST(SampleNumbers, OtherPixelsSamplesAndSeedsOtherNumbers) {
    std::set<double> seen;
    for (int pixel = 0; pixel < 32; ++pixel)
        for (int sample = 0; sample < 32; ++sample)
            for (int seed = 0; seed < 4; ++seed)
                seen.insert(SampleNumbers({32, random, 1, seed}, {pixel, pixel / 3}, static_cast<std::uint32_t>(sample))
                                .pair(Purpose::pixel)
                                .x);
    // 4096 numbers of 32 bits: two are equal once in five hundred such tests, and these are always the same.
    EXPECT_EQ(seen.size(), 4096u);
}

/// Error of the share of a pixel that lies below an edge, over many pixels: root of the mean square.
double rmsAtEdge(const SamplePattern& pattern) {
    constexpr double kEdge = -0.2125; // below y = x - 0.2125: 31 % of the pixel
    constexpr double kTruth = (1 + kEdge) * (1 + kEdge) / 2;
    double squares = 0;
    constexpr int kPixels = 3000;
    for (int pixel = 0; pixel < kPixels; ++pixel) {
        int below = 0;
        for (const dvec2& p : pairsOf(pattern, {pixel % 60, pixel / 60}, Purpose::pixel))
            below += p.y < p.x + kEdge ? 1 : 0;
        const double error = static_cast<double>(below) / pattern.count - kTruth;
        squares += error * error;
    }
    return std::sqrt(squares / kPixels);
}

TEST(SampleNumbers, ErrorsAtAnEdgeFallAsTheyMust) {
    const std::vector<int> counts{4, 16, 64, 256};
    // In closed form: by chance sqrt(p (1 - p) / N); jittered sqrt(sum of c (1 - c) over cells) / N, c what the edge covers.
    const std::vector<double> byChance{.2305, .1157, .0578, .0289}, byCell{.1490, .0536, .0185, .00653};
    std::vector<double> randoms, jittereds, evens;
    for (std::size_t i = 0; i < counts.size(); ++i) {
        randoms.push_back(rmsAtEdge({counts[i], random, 1, 1}));
        jittereds.push_back(rmsAtEdge({counts[i], jittered, 1, 1}));
        evens.push_back(rmsAtEdge({counts[i], lowDiscrepancy, 1, 1}));
        // 3000 pixels know a root mean square to 1.3 %; four times that.
        EXPECT_NEAR(randoms.back(), byChance[i], 0.055 * byChance[i]);
        EXPECT_NEAR(jittereds.back(), byCell[i], 0.055 * byCell[i]);
        EXPECT_LT(evens.back(), randoms.back());
    }
    EXPECT_NEAR(testing::logSlope(counts, randoms), -0.5, 0.05);
    EXPECT_NEAR(testing::logSlope(counts, jittereds), -0.75, 0.07);
    EXPECT_NEAR(testing::logSlope(counts, evens), -0.75, 0.1);
}

} // namespace
} // namespace shadowlab::ray_tracing
