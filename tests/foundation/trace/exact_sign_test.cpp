// The exact sign against whole-number arithmetic, on cases made so that plain double gets many of them wrong.
// SPDX-License-Identifier: MIT
#include "techniques/foundation/trace/judge/exact_sign.h"

#include <gtest/gtest.h>

#include "techniques/foundation/trace/ray_triangle.h"
#include "tests/foundation/trace/ray_meshes.h"

namespace shadowlab::trace {
namespace {

__extension__ using Whole = __int128;

/// The same determinant in whole numbers.
Whole wholeTriple(const glm::i64vec3& d, const glm::i64vec3& p, const glm::i64vec3& q) {
    const auto cross = [&](int j, int k) { return Whole(p[j]) * q[k] - Whole(p[k]) * q[j]; };
    return d.x * cross(1, 2) + d.y * cross(2, 0) + d.z * cross(0, 1);
}
int signOf(Whole value) { return value > 0 ? 1 : value < 0 ? -1 : 0; }

glm::i64vec3 randomWhole(testing::Random& random, double largest) {
    return glm::i64vec3(glm::round(testing::inCube(random, largest)));
}

TEST(ExactSign, IsThatOfWholeNumberArithmeticWherePlainDoubleFails) {
    testing::Random random(11);
    int zeros = 0, compared = 0, naiveWrong = 0;
    for (int i = 0; i < 200'000; ++i) {
        // Nearly in one plane: a direction spanned by the two corners with whole weights, moved by at most one unit.
        // 2^36 and 2^7 keep the terms below 2^120, within 128 bits, and beyond twice the 53 of double.
        const glm::i64vec3 p = randomWhole(random, 0x1p36), q = randomWhole(random, 0x1p36);
        const glm::i64vec3 weights = randomWhole(random, 0x1p7), moved = randomWhole(random, 0.9);
        const glm::i64vec3 direction = weights.x * p + weights.y * q + moved;
        const glm::i64vec3 origin = randomWhole(random, 0x1p36);
        const dvec3 d(direction), o(origin), b(origin + p), c(origin + q);
        const int truth = signOf(wholeTriple(direction, p, q));
        ASSERT_EQ(exactTripleSign(d, o, b, c), truth) << i;
        const double naive = glm::dot(d, glm::cross(b - o, c - o));
        naiveWrong += (naive > 0 ? 1 : naive < 0 ? -1 : 0) != truth;
        zeros += truth == 0;
        ++compared;
    }
    EXPECT_EQ(compared, 200'000);
    EXPECT_GT(zeros, 1000);
    EXPECT_GT(naiveWrong, 10'000) << "the cases are too easy to prove anything";
}

TEST(ExactSign, SeesDifferencesThatSubtractionRoundsAway) {
    // b - origin is not a double: its lowest bit is lost by the subtraction, and decides.
    const dvec3 direction(0, 0, 1), origin(0x1p60, 0, 0), c(0x1p60, 1, 0);
    const dvec3 onEdge(0x1p60, 5, 0);
    EXPECT_EQ(exactTripleSign(direction, origin, onEdge, c), 0);
    // (b - origin) x (c - origin) has the z component (b.x - o.x) * 1, for b.x - o.x = tiny - 2^60.
    EXPECT_EQ(exactTripleSign(direction, origin, dvec3(0x1p-60, 5, 0), c), -1);
    EXPECT_EQ(exactTripleSign(direction, dvec3(0x1p-60, 0, 0), dvec3(0, 5, 0), dvec3(0x1p-60, 1, 0)), -1);
}

/// Through a point of the edge between two triangles, to within rounding: exactly one of the two is hit, or, when the
/// ray meets the edge itself, both. Without the exact sign, the answer depends on rounding.
TEST(ExactSign, DecidesRaysThroughSharedEdgesAsTheirCoordinatesSay) {
    testing::Random random(5);
    int hitOne = 0, hitBoth = 0;
    for (int i = 0; i < 100'000; ++i) {
        const dvec3 a = testing::inCube(random, 1), b = testing::inCube(random, 1);
        const dvec3 left = testing::inCube(random, 1), right = a + b - left; // on the other side of the edge
        const double share = 0.1 + 0.8 * testing::inCube(random, 0.5).x + 0.4;
        const dvec3 onEdge = a + std::clamp(share, 0.1, 0.9) * (b - a);
        Ray ray;
        ray.originCentred = testing::inCube(random, 1) + dvec3(0, 0, 5);
        ray.directionCentred = onEdge - ray.originCentred;
        const ShearedRay sheared(ray);
        const int hits =
            int(bool(intersect(sheared, {a, b, left}, 10))) + int(bool(intersect(sheared, {b, a, right}, 10)));
        const int sign = exactTripleSign(ray.directionCentred, ray.originCentred, a, b);
        ASSERT_EQ(hits, sign == 0 ? 2 : 1) << i;
        hitOne += hits == 1;
        hitBoth += hits == 2;
    }
    EXPECT_GT(hitOne, 50'000);
    EXPECT_EQ(hitOne + hitBoth, 100'000);
}

} // namespace
} // namespace shadowlab::trace
