// The form factor of a point against Lambert's sum with the library's atan2, for edges under small and large angles.
// SPDX-License-Identifier: MIT
#include "techniques/radiosity/form_factors/point_form_factor.h"

#include <cmath>
#include <limits>
#include <random>

#include <glm/gtc/constants.hpp>
#include <gtest/gtest.h>

namespace shadowlab::radiosity {
namespace {

struct Sum {
    double value = 0, ofSizes = 0; ///< of the edges' shares; of their absolute values
};
/// For a point at the origin that looks along +y. `smallest`, `largest`: tangents of the angles of edges that were met.
Sum sumOf(const Polygon& polygon, double& smallest, double& largest) {
    Sum sum;
    for (std::size_t i = 0; i < polygon.count(); ++i) {
        const dvec3 &from = polygon[i], &to = polygon[(i + 1) % polygon.count()], across = glm::cross(to, from);
        const double size = glm::length(across), along = glm::dot(to, from);
        const double share = std::atan2(size, along) * across.y / size / (2 * glm::pi<double>());
        sum.value += share;
        sum.ofSizes += std::abs(share);
        smallest = std::min(smallest, along > 0 ? size / along : smallest);
        largest = std::max(largest, along > 0 ? size / along : std::numeric_limits<double>::infinity());
    }
    return sum;
}

TEST(PointFormFactorTest, AnglesAreThoseOfTheLibrary) {
    std::mt19937 dice(3);
    std::uniform_real_distribution<double> share(0, 1), exponent(-4, 1);
    double smallest = 1, largest = 0;
    int between = 0; // angles for which the two ways to find them meet
    for (int i = 0; i < 20000; ++i) {
        // A square before the point, from much smaller to ten times as large as it is far.
        const double side = std::pow(10, exponent(dice));
        const dvec3 corner(share(dice) - 0.5, 1 + share(dice), share(dice) - 0.5);
        const Polygon square{corner, corner + dvec3(side, 0, 0), corner + dvec3(side, 0, side), corner + dvec3(0, 0, side)};
        const Sum sum = sumOf(square, smallest, largest);
        ASSERT_GT(sum.ofSizes, 0);
        // An angle may be off by three units in the last place; all else is computed alike.
        EXPECT_NEAR(pointFormFactor(dvec3(0), {0, 1, 0}, square), sum.value, 4 * std::numeric_limits<double>::epsilon() * sum.ofSizes);
        between += side > 0.2 && side < 2;
    }
    EXPECT_LT(smallest, 1e-3);
    EXPECT_GT(largest, 3);
    EXPECT_GT(between, 3000);
}

} // namespace
} // namespace shadowlab::radiosity
