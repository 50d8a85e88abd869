// Boundaries: their length, distances against brute force, and shapes whose displacement is known.
// SPDX-License-Identifier: MIT
#include "app/judge/metrics/boundary.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <random>

namespace shadowlab::judge {
namespace {

Grid<Shade> shades(ivec2 size, const std::function<bool(double x, double y)>& lit) {
    Grid<Shade> grid(size.x, size.y);
    for (int y = 0; y < size.y; ++y)
        for (int x = 0; x < size.x; ++x)
            grid.at(x, y) = lit(x + 0.5, y + 0.5) ? Shade::lit : Shade::shadowed;
    return grid;
}
Grid<std::uint32_t> oneReceiver(ivec2 size) { return {size.x, size.y, 7}; }
std::vector<BoundaryEdge> edgesOf(const Grid<Shade>& grid) {
    return boundaryEdges(grid, oneReceiver({grid.width, grid.height}));
}

TEST(Boundary, LiesBetweenLitAndShadowedOfOneReceiverOnly) {
    Grid<Shade> grid(4, 1);
    grid.values = {Shade::lit, Shade::shadowed, Shade::turnedAway, Shade::lit};
    EXPECT_EQ(edgesOf(grid), (std::vector<BoundaryEdge>{{2, 1}}));
    Grid<std::uint32_t> receivers(4, 1, 0);
    receivers.values = {0, 1, 1, 1};
    EXPECT_TRUE(boundaryEdges(grid, receivers).empty());
    Grid<Shade> column(1, 3);
    column.values = {Shade::shadowed, Shade::lit, Shade::outside};
    EXPECT_EQ(edgesOf(column), (std::vector<BoundaryEdge>{{1, 2}}));
}

// Cauchy: a staircase is longer than its line by |cos a| + |sin a|; over all directions, as a circle has them, by 4/pi.
TEST(Boundary, LengthOfACircleIsItsCircumference) {
    for (const double radius : {20.0, 77.7, 150.0}) {
        const auto disc = shades({401, 401}, [&](double x, double y) { return std::hypot(x - 200, y - 200) > radius; });
        // The staircase of a circle has 8 r edges, give or take a few where it turns.
        EXPECT_NEAR(lengthPx(edgesOf(disc)), 2 * M_PI * radius, 4);
    }
}

TEST(Boundary, DistancesAreThoseOfBruteForce) {
    std::mt19937 random(1);
    for (const double density : {0.5, 0.02, 0.001}) {
        std::bernoulli_distribution dark(density);
        const ivec2 size{61, 47};
        Grid<Shade> grid(size.x, size.y);
        for (Shade& shade : grid.values)
            shade = dark(random) ? Shade::shadowed : Shade::lit;
        const auto edges = edgesOf(grid);
        ASSERT_GE(edges.size(), 4u);
        const Grid<float> distances = distanceToBoundary(edges, size);
        for (int y = 0; y < size.y; ++y)
            for (int x = 0; x < size.x; ++x) {
                double nearest = std::numeric_limits<double>::infinity();
                for (const BoundaryEdge& edge : edges)
                    nearest = std::min(nearest, std::hypot(x + 0.5 - edge.x / 2.0, y + 0.5 - edge.y / 2.0));
                ASSERT_FLOAT_EQ(distances.at(x, y), static_cast<float>(nearest)) << x << ", " << y;
            }
    }
}

TEST(Boundary, WithoutOneEverythingIsInfinitelyFar) {
    const Grid<float> distances = distanceToBoundary({}, {5, 4});
    ASSERT_EQ(distances.values.size(), 20u);
    for (const float distance : distances.values)
        EXPECT_EQ(distance, std::numeric_limits<float>::infinity());
    EXPECT_FALSE(displacement({}, {{2, 1}}, {5, 4}));
    EXPECT_FALSE(displacement({{2, 1}}, {}, {5, 4}));
}

TEST(Boundary, AShiftedEdgeIsDisplacedByTheShift) {
    const ivec2 size{100, 60};
    const auto halfPlane = [&](double at) { return edgesOf(shades(size, [=](double x, double) { return x > at; })); };
    for (const int shift : {0, 1, 7}) {
        const auto moved = displacement(halfPlane(40), halfPlane(40 + shift), size);
        ASSERT_TRUE(moved);
        EXPECT_DOUBLE_EQ(moved->mean, shift);
        EXPECT_DOUBLE_EQ(moved->p95, shift);
        EXPECT_DOUBLE_EQ(moved->max, shift);
    }
}

TEST(Boundary, AGrownDiscIsDisplacedByItsGrowth) {
    const ivec2 size{300, 300};
    const auto disc = [&](double radius) {
        return edgesOf(shades(size, [=](double x, double y) { return std::hypot(x - 150, y - 150) > radius; }));
    };
    const auto moved = displacement(disc(80), disc(90), size);
    ASSERT_TRUE(moved);
    // A staircase strays from its circle by up to half the diagonal of a pixel, to both sides alike; of the other
    // staircase it is the nearest edge that counts, so one on the near side.
    EXPECT_LE(moved->mean, 10);
    EXPECT_GE(moved->mean, 10 - std::sqrt(0.5));
    EXPECT_LE(moved->max, 10 + 2 * std::sqrt(0.5));
}

TEST(Boundary, CoreErrorsLieFartherThanAliasingReaches) {
    const ivec2 size{40, 10};
    const auto edges = edgesOf(shades(size, [](double x, double) { return x > 20; }));
    const Grid<float> distances = distanceToBoundary(edges, size);
    const auto coreIn = [&](int column, double texelPx) {
        Grid<std::uint8_t> wrong(size.x, size.y);
        wrong.at(column, 5) = 1;
        return coreErrors(wrong, distances,
                          texelPx > 0 ? std::optional(Grid<float>(size.x, size.y, float(texelPx))) : std::nullopt);
    };
    EXPECT_EQ(coreIn(20, 0), 0); // 0.5 px from the boundary
    EXPECT_EQ(coreIn(21, 0), 0); // 1.5 px: not farther than that
    EXPECT_EQ(coreIn(22, 0), 1);
    EXPECT_EQ(coreIn(22, 3), 0) << "within one and a half texels of three pixels";
    EXPECT_EQ(coreIn(24, 3), 0); // 4.5 px
    EXPECT_EQ(coreIn(25, 3), 1);
    EXPECT_EQ(coreIn(22, 0.1), 1) << "small texels do not shrink the band below 1.5 px";
}

} // namespace
} // namespace shadowlab::judge
