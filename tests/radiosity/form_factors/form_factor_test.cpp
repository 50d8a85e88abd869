// Form factors against closed forms: Lambert's sum from a point, rectangles, and polygons by quadrature. The numbers are the
// formulas' values to twelve digits, from J. R. Howell's catalogue of configuration factors (entries in brackets).
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cmath>

#include <glm/gtc/constants.hpp>

#include "techniques/radiosity/form_factors/point_form_factor.h"
#include "techniques/radiosity/form_factors/polygon_exchange.h"
#include "techniques/radiosity/form_factors/rectangle_exchange.h"

namespace shadowlab::radiosity {
namespace {

// What a dozen printed digits leave open.
constexpr double kPrinted = 1e-11;

const dvec3 kUp(0, 1, 0);

/// In the plane y = height, facing down (or up, seen from above).
Polygon level(double fromX, double toX, double fromZ, double toZ, double height, bool facesUp) {
    const dvec3 a(fromX, height, fromZ), b(fromX, height, toZ), c(toX, height, toZ), d(toX, height, fromZ);
    return facesUp ? Polygon{a, b, c, d} : Polygon{a, d, c, b};
}
/// In the plane x = 0, facing +x.
Polygon wall(double fromZ, double toZ, double fromY, double toY) {
    return {{0, fromY, fromZ}, {0, toY, fromZ}, {0, toY, toZ}, {0, fromY, toZ}};
}

TEST(PointFormFactor, ToARectangle) {
    // Parallel, below a corner [B-3].
    const auto below = [](double a, double b) { return pointFormFactor(dvec3(0), kUp, level(0, a, 0, b, 1, false)); };
    EXPECT_NEAR(below(1, 1), .138531605995, kPrinted);
    EXPECT_NEAR(below(.5, .5), .0598641176152, kPrinted);
    EXPECT_NEAR(below(2, 1), .167375009914, kPrinted);
    EXPECT_NEAR(below(100, 100), .249979543986, kPrinted);
    EXPECT_NEAR(pointFormFactor(dvec3(0), kUp, level(-.5, .5, -.5, .5, 1, false)), .239456470461, kPrinted);
    // Perpendicular, on the line through a corner [B-5]: height, width b = 1, distance.
    const auto beside = [](double height, double distance) {
        return pointFormFactor({distance, 0, 0}, kUp, wall(0, 1, 0, height));
    };
    EXPECT_NEAR(beside(1, 1), .0557341970026, kPrinted);
    EXPECT_NEAR(beside(2, 1), .0950679411924, kPrinted);
    EXPECT_NEAR(beside(1, 2), .01392769121, kPrinted);
}

/// A disc as a fan of triangles; what is wrong with it falls with the square of their number, so two numbers give the limit.
template <typename Sum>
double limitOfFans(int triangles, const Sum& sum) {
    const double coarse = sum(triangles), fine = sum(2 * triangles);
    return fine + (fine - coarse) / 3;
}
Polygon sector(const dvec3& middle, double radius, double from, double to) {
    const auto rim = [&](double angle) { return middle + radius * dvec3(std::cos(angle), 0, std::sin(angle)); };
    return {middle, rim(from), rim(to)}; // faces down: x to z is clockwise from above
}

TEST(PointFormFactor, ToADisc) {
    const auto toDisc = [](double height, double radius, double offset) {
        return limitOfFans(1024, [&](int n) {
            double sum = 0;
            for (int i = 0; i < n; ++i)
                sum += pointFormFactor(dvec3(0), kUp,
                                       sector({offset, height, 0}, radius, glm::two_pi<double>() * i / n,
                                              glm::two_pi<double>() * (i + 1) / n));
            return sum;
        });
    };
    // The limit is left wrong by the fourth power of the angle of a triangle: (2 pi / 2048)^4 = 9e-11 of the value, and a margin.
    EXPECT_NEAR(toDisc(1, 1, 0), .5, 1e-9);
    EXPECT_NEAR(toDisc(1, .5, 0), .2, 1e-9);
    EXPECT_NEAR(toDisc(1, 1, 1), .27639320225, 1e-9);
    EXPECT_NEAR(toDisc(1, .5, 2), .0107251075066, 1e-9);
}

TEST(PointFormFactor, OfASmallAngleHasAllItsDigits) {
    // A square of a thousandth of a millimetre, 1 km away: by the cosine of the angles (acos) nothing is left.
    const Polygon square = level(-5e-7, 5e-7, -5e-7, 5e-7, 1000, false);
    const double factor = pointFormFactor(dvec3(0), kUp, square);
    const double truth = 1e-12 / (glm::pi<double>() * 1e6);
    EXPECT_NEAR(factor / truth, 1, 1e-12); // some roundings, none of them of a small difference
    double naive = 0;
    for (std::size_t i = 0; i < 4; ++i) {
        const dvec3 from = glm::normalize(square[i]), to = glm::normalize(square[(i + 1) % 4]);
        naive += std::acos(std::min(1.0, glm::dot(from, to))) * glm::dot(kUp, glm::normalize(glm::cross(to, from)));
    }
    EXPECT_GT(std::abs(naive / (2 * glm::pi<double>()) / truth - 1), 0.1) << "the case is too easy to prove anything";
}

double parallel(double x, double y) { // form factor, at distance 1 [C-11]
    return unoccludedExchange(level(0, x, 0, y, 0, true), level(0, x, 0, y, 1, false)).area / (x * y);
}
double perpendicular(double h, double w) { // from the floor w x 1 to the wall h x 1 [C-14]
    return unoccludedExchange(level(0, w, 0, 1, 0, true), wall(0, 1, 0, h)).area / w;
}

TEST(RectangleExchange, ParallelAndPerpendicular) {
    EXPECT_NEAR(parallel(1, 1), .199824895698, kPrinted);
    EXPECT_NEAR(parallel(2, 1), .285875384851, kPrinted);
    EXPECT_NEAR(parallel(2, 2), .415253283577, kPrinted);
    EXPECT_NEAR(parallel(.1, .1), .00316205683876, kPrinted);
    EXPECT_NEAR(parallel(10, 10), .826994522397, kPrinted);
    EXPECT_NEAR(parallel(100, 100), .980416602926, kPrinted);
    EXPECT_NEAR(parallel(1000, 1000), .998005631908, 1e-10); // terms of a million square metres
    EXPECT_NEAR(perpendicular(1, 1), .200043776075, kPrinted);
    EXPECT_NEAR(perpendicular(2, 1), .232852602795, kPrinted);
    EXPECT_NEAR(perpendicular(1, 2), .116426301398, kPrinted);
    EXPECT_NEAR(perpendicular(.5, 1), .146186679106, kPrinted);
    EXPECT_NEAR(perpendicular(.1, 1), .0432513694007, kPrinted);
    EXPECT_NEAR(perpendicular(10, 1), .24920948579, kPrinted);
    EXPECT_NEAR(perpendicular(1, .1), .432513694007, kPrinted);
    EXPECT_NEAR(parallel(1, 1) + 4 * perpendicular(1, 1), 1, 1e-14) << "a unit cube is closed";
}

TEST(RectangleExchange, LongStripsAreThoseOfThePlane) {
    // Hottel's crossed strings: what the ends lose falls with the length.
    const double length = 1e5;
    EXPECT_NEAR(unoccludedExchange(level(0, 1, 0, length, 0, true), level(0, 1, 0, length, 1, false)).area / length,
                std::sqrt(2.0) - 1, 1 / length);
    EXPECT_NEAR(unoccludedExchange(level(0, 1, 0, length, 0, true), wall(0, length, 0, 1)).area / length,
                1 - std::sqrt(0.5), 1 / length);
}

/// By any rotation and at any place, in pieces or as a whole, from either side, the exchange is the same.
TEST(RectangleExchange, TurnedMovedAndInPieces) {
    const dvec3 axis = glm::normalize(dvec3(1, 2, -0.5));
    const auto turned = [&](const Polygon& p) {
        Polygon q;
        for (const dvec3& c : p.corners()) { // Rodrigues
            const double angle = 0.7;
            q.add(dvec3(3, -2, 5) + c * std::cos(angle) + glm::cross(axis, c) * std::sin(angle) +
                  axis * glm::dot(axis, c) * (1 - std::cos(angle)));
        }
        return q;
    };
    int compared = 0;
    for (int i = 0; i < 4; ++i)
        for (int j = 0; j < 4; ++j) {
            const Polygon floor = level(0.25 * i, 0.25 * i + 0.25, 0, 1, 0, true);
            const Polygon side = wall(-1, 0.3, 0.5 * j, 0.5 * j + 0.5);
            const double exchange = unoccludedExchange(floor, side).area;
            EXPECT_NEAR(unoccludedExchange(side, floor).area / exchange, 1, 1e-10);
            EXPECT_NEAR(unoccludedExchange(turned(floor), turned(side)).area / exchange, 1, 1e-10);
            ASSERT_TRUE(rectangleExchange(turned(floor), turned(side)));
            // Quadrature promises a ten millionth.
            EXPECT_NEAR(exchangeByQuadrature(turned(floor), turned(side)).area / exchange, 1, 1e-7);
            EXPECT_NEAR(exchangeByQuadrature(side, floor).area / exchange, 1, 1e-7);
            ++compared;
        }
    EXPECT_EQ(compared, 16);
    double sum = 0;
    for (int i = 0; i < 4; ++i)
        for (int j = 0; j < 4; ++j)
            sum += unoccludedExchange(level(0.25 * i, 0.25 * i + 0.25, 0, 1, 0, true),
                                      wall(0, 1, 0.25 * j, 0.25 * j + 0.25))
                       .area;
    EXPECT_NEAR(sum, .200043776075403, 1e-13);
}

TEST(RectangleExchange, FarAndSmallGoesToQuadrature) {
    // A square centimetre to another 20 m away: the sixteen terms are four hundred square metres each.
    const Polygon near = level(0, .01, 0, .01, 0, true), far = level(0, .01, 0, .01, 20, false);
    EXPECT_FALSE(rectangleExchange(near, far));
    // To the fourth power of size over distance the kernel is constant: 1e-13.
    EXPECT_NEAR(unoccludedExchange(near, far).area / (1e-8 / (glm::pi<double>() * 400)), 1, 3e-7);
}

TEST(PolygonExchange, WhatLiesBehindCountsNothing) {
    const Polygon floor = level(0, 1, 0, 1, 0, true);
    EXPECT_EQ(unoccludedExchange(floor, level(0, 1, 0, 1, 1, true)).area, 0) << "it faces away";
    EXPECT_EQ(unoccludedExchange(floor, level(2, 3, 0, 1, 0, true)).area, 0) << "one plane";
    // Of a wall that goes on below the floor the upper part counts; and only the part of the floor before the wall.
    const double upper = unoccludedExchange(floor, wall(0, 1, 0, 1)).area;
    EXPECT_NEAR(unoccludedExchange(floor, wall(0, 1, -2, 1)).area, upper, 1e-12);
    EXPECT_NEAR(unoccludedExchange(level(-3, 1, 0, 1, 0, true), wall(0, 1, -2, 1)).area, upper, 1e-12);
}

TEST(PolygonExchange, TrianglesAndAnyPolygonsInPieces) {
    // Two triangles are their square; a triangle's exchange with another is that of its four quarters.
    const Polygon square = level(0, 1, 0, 1, 1, false);
    const Polygon first{square[0], square[1], square[2]}, second{square[0], square[2], square[3]};
    const Polygon tilted{{-.3, .1, -.2}, {-.4, .2, .9}, {.8, -.3, .5}};
    int compared = 0;
    for (const Polygon& other : {level(0, 1, 0, 1, 0, true), wall(0, 1, 0, 1), tilted}) {
        const double whole = exchangeByQuadrature(square, other).area;
        EXPECT_GT(whole, 0.01);
        EXPECT_NEAR((exchangeByQuadrature(first, other).area + exchangeByQuadrature(second, other).area) / whole, 1,
                    2e-7); // each side of the comparison promises 1e-7
        EXPECT_NEAR(exchangeByQuadrature(other, square).area / whole, 1, 2e-7);
        ++compared;
    }
    EXPECT_EQ(compared, 3);
}

TEST(PolygonExchange, ThreeLongStripsOfEqualWidthExchangeHalf) {
    // A tent of equal sides (crossed strings: 1/2); what the ends lose falls with the length, so two lengths give the limit.
    const auto factor = [](double length) {
        const double height = std::sqrt(0.75);
        const Polygon floor = level(0, 1, 0, length, 0, true);
        const Polygon slope{{0, 0, 0}, {.5, height, 0}, {.5, height, length}, {0, 0, length}};
        return unoccludedExchange(floor, slope).area / length;
    };
    const double shorter = factor(20), longer = factor(40);
    EXPECT_NEAR(2 * longer - shorter, 0.5,
                1e-5); // the next term is the squared width over the squared length, some 1e-3/40^2
    EXPECT_LT(longer, 0.5);
}

TEST(PolygonExchange, CoaxialDiscs) {
    // By symmetry of one sector of the lower disc to all of the upper.
    const auto factor = [](double lower, double upper, double height) {
        return limitOfFans(24, [&](int n) {
            const auto angle = [&](int i) { return glm::two_pi<double>() * i / n; };
            Polygon from = sector(dvec3(0), lower, angle(0), angle(1));
            from = {from[0], from[2], from[1]}; // faces up
            double sum = 0;
            for (int i = 0; i < n; ++i)
                sum += unoccludedExchange(from, sector({0, height, 0}, upper, angle(i), angle(i + 1)), 1e-6).area;
            return sum / glm::length(areaVector(from));
        });
    };
    // Two numbers of sectors leave the fourth power of the angle: (2 pi / 48)^4 = 3e-4 of a difference of some per cent.
    EXPECT_NEAR(factor(1, 1, 1), (3 - std::sqrt(5.0)) / 2, 3e-5);
    EXPECT_NEAR(factor(.5, .5, 1), 3 - 2 * std::sqrt(2.0), 3e-5);
    EXPECT_NEAR(factor(1, 2, 1), .7639320225, 3e-5);
    EXPECT_NEAR(factor(2, 1, 1), .190983005625, 3e-5);
}

/// The kernel between two middles, cos cos / (pi r^2), is what many programs take for the form factor of two patches.
TEST(PolygonExchange, TheNaiveKernelFailsWherePatchesTouch) {
    const auto kernel = [](const Polygon& a, const Polygon& b) {
        const Plane from = planeOf(a), to = planeOf(b);
        const dvec3 apart = to.point - from.point;
        const double square = glm::dot(apart, apart);
        return glm::dot(from.normal, apart) * -glm::dot(to.normal, apart) / (glm::pi<double>() * square * square);
    };
    const auto naive = [&](bool adjacent, int n) { // the exchange of unit squares of a cube, cut into n x n
        double sum = 0;
        for (int i = 0; i < n * n; ++i)
            for (int j = 0; j < n * n; ++j) {
                const double x = double(i % n) / n, z = double(i / n) / n, u = double(j % n) / n, v = double(j / n) / n,
                             s = 1.0 / n;
                const Polygon floor = level(x, x + s, z, z + s, 0, true);
                const Polygon other = adjacent ? wall(u, u + s, v, v + s) : level(u, u + s, v, v + s, 1, false);
                sum += kernel(floor, other) / std::pow(n, 4);
            }
        return sum;
    };
    // Too large by 59 % where they touch, and that only falls with the number of cuts, not its square.
    EXPECT_NEAR(naive(false, 1), .318310, 1e-6);
    EXPECT_NEAR(naive(true, 1), .318310, 1e-6);
    EXPECT_NEAR(naive(true, 2) / .200043776075, 1.32, .005);
    EXPECT_NEAR(naive(true, 8) / .200043776075, 1.083, .001);
    EXPECT_NEAR(naive(false, 8) / .199824895698, 1.0047, .0002);
    EXPECT_NEAR(exchangeByQuadrature(level(0, 1, 0, 1, 0, true), wall(0, 1, 0, 1)).area, .200043776075, 2e-8);
}

} // namespace
} // namespace shadowlab::radiosity
