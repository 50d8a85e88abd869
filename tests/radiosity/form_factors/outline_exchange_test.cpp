// Exchange along outlines against closed forms and against quadrature over areas.
// SPDX-License-Identifier: MIT
#include "techniques/radiosity/form_factors/outline_exchange.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace shadowlab::radiosity {
namespace {

/// In the plane z = height; faces up or down.
Polygon level(double side, double height, bool up) {
    if (up) return {{0, 0, height}, {side, 0, height}, {side, side, height}, {0, side, height}};
    return {{0, 0, height}, {0, side, height}, {side, side, height}, {side, 0, height}};
}

/// A rectangle on the edge y = 0 of level(1, 0, true), at that angle to it, from x = `begin` on.
Polygon leaf(double begin, double width, double height, double degrees) {
    const double c = std::cos(glm::radians(degrees)), s = std::sin(glm::radians(degrees));
    const dvec3 up(0, height * c, height * s), right(width, 0, 0), from(begin, 0, 0);
    return {from, from + up, from + right + up, from + right}; // its front is on the side of the other
}

TEST(OutlineExchange, IsThatOfClosedForms) {
    // Unit squares with a metre between them, and at right angles along an edge (J. Howell, A Catalog of Radiation Heat Transfer Configuration Factors).
    const std::optional<Exchange> parallel = exchangeByOutlines(level(1, 0, true), level(1, 1, false), 1e-10);
    ASSERT_TRUE(parallel);
    EXPECT_NEAR(parallel->area, 0.19982489569838746, 1e-11); // half of what is promised: a share of 1e-10
    const std::optional<Exchange> upright = exchangeByOutlines(level(1, 0, true), leaf(0, 1, 1, 90), 1e-10);
    ASSERT_TRUE(upright);
    EXPECT_NEAR(upright->area, 0.200043776075403, 1e-11);
    // A millimetre apart: quadrature over areas runs out of pieces.
    const std::optional<Exchange> plates = exchangeByOutlines(level(1, 0, true), level(1, 1e-3, false), 1e-9);
    ASSERT_TRUE(plates);
    const double x = 1e3, y = 1e3; // side over distance
    const auto half = [](double p, double q) { return p * std::sqrt(1 + q * q) * std::atan(p / std::sqrt(1 + q * q)); };
    const double exact = 2 / (glm::pi<double>() * x * y) *
                         (std::log(std::sqrt((1 + x * x) * (1 + y * y) / (1 + x * x + y * y))) + half(x, y) + half(y, x) - x * std::atan(x) - y * std::atan(y));
    EXPECT_NEAR(plates->area / exact, 1, 1e-9);
}

TEST(OutlineExchange, IsThatOfQuadratureWherePolygonsTouch) {
    std::mt19937 random(5);
    const auto between = [&](double low, double high) { return std::uniform_real_distribution(low, high)(random); };
    int compared = 0;
    for (int i = 0; i < 60; ++i) {
        // With a whole edge in common, with parts of edges, at a corner alone, and somewhat apart.
        const Polygon floor = level(1, 0, true);
        const double begin = i % 4 == 0 ? 0 : i % 4 == 1 ? between(-0.5, 0.9) : i % 4 == 2 ? 1 : between(1.01, 1.2);
        const Polygon other = leaf(begin, i % 4 == 0 ? 1 : between(0.2, 1), between(0.1, 2), between(20, 150));
        const std::optional<Exchange> found = exchangeByOutlines(floor, other, 1e-8), reversed = exchangeByOutlines(other, floor, 1e-8);
        if (!found || !reversed) continue; // too much is lost by rounding
        const Exchange byArea = exchangeByQuadrature(floor, other, 1e-8);
        ASSERT_GT(byArea.area, 0);
        EXPECT_LE(std::abs(found->area - byArea.area), found->error + byArea.error + 1e-8 * byArea.area) << i;
        EXPECT_NEAR(reversed->area / found->area, 1, 1e-8) << i;
        ++compared;
    }
    EXPECT_GE(compared, 55);
}

TEST(OutlineExchange, IsLeftToQuadratureWhereItsTermsCancel) {
    // A square centimetre, one metre above the plane of a square kilometre and three kilometres beside it.
    const Polygon field = level(1000, 0, true);
    const Polygon tile{{-3000, 0, 1}, {-3000, 0.01, 1}, {-3000, 0.01, 1.01}, {-3000, 0, 1.01}};
    EXPECT_FALSE(exchangeByOutlines(field, tile, 1e-7));
}

// The side of a box whose foot floats have moved a few nanometres below a ground of half a kilometre: no rectangles at right angles any more, so that
// there is no closed form. Summed over the box it is found as well; over the ground it took 16,000 pieces.
TEST(OutlineExchange, OfABoxOnAWideGroundIsSummedOverTheBox) {
    const Polygon ground = level(500, 0, true);
    const auto side = [](double foot) { return Polygon{{200, 300, foot}, {200, 300, 0.18}, {200.18, 300, 0.18}, {200.18, 300, foot}}; };
    const Polygon standing = side(0), sunk = side(-3.6e-9), tilted{{200, 300, -3.6e-9}, {200, 300, 0.18}, {200.18, 300 + 1e-9, 0.18}, {200.18, 300 + 1e-9, -3.6e-9}};
    const double exact = unoccludedExchange(ground, standing).area; // by the closed form
    EXPECT_GT(exact, 0.1 * 0.18 * 0.18);
    for (const Polygon& face : {sunk, tilted}) {
        EXPECT_NEAR(unoccludedExchange(ground, face).area / exact, 1, 1e-6); // what is below the ground is a share of 4e-8
        EXPECT_EQ(unoccludedExchange(ground, face).area, unoccludedExchange(face, ground).area) << "whichever comes first, the sum goes over the box";
    }
}

} // namespace
} // namespace shadowlab::radiosity
