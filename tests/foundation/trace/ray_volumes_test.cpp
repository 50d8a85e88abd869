// Rays against boxes and balls: none that is touched may be left out. Each beside a plain version that does leave some out.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "techniques/foundation/trace/structures/ray_volumes.h"
#include "tests/foundation/trace/exact_slabs.h"
#include "tests/foundation/trace/ray_meshes.h"

namespace shadowlab::trace {
namespace {

using namespace shadowlab::testing;

double enterOf(const Ray& ray, const auto& volume) {
    const ShearedRay sheared(ray);
    return VolumeRay(sheared).enter(volume, sheared.farthest);
}

/// The slabs as they are first written down: by the smaller and the larger of two quotients, whatever these are.
bool touchesPlainly(const Ray& ray, const Box& box) {
    double enter = 0, leave = std::numeric_limits<double>::infinity();
    for (int axis = 0; axis < 3; ++axis) {
        const double inverse = 1 / ray.directionCentred[axis];
        double in = (box.lowerCentred[axis] - ray.originCentred[axis]) * inverse;
        double out = (box.upperCentred[axis] - ray.originCentred[axis]) * inverse;
        if (in > out) std::swap(in, out);
        if (!(in <= leave && out >= enter)) return false;
        enter = std::max(enter, in);
        leave = std::min(leave, out);
    }
    return enter <= leave;
}

TEST(RayVolumesTest, BoxesAndEverySignOfZero) {
    const double directions[] = {0.0, -0.0, 1.0, -1.0}, origins[] = {-1, 1, 0, 2, -2};
    const Box box{dvec3(-1), dvec3(1)};
    int compared = 0, touched = 0, plainlyWrong = 0;
    for (int d = 0; d < 64; ++d)
        for (int o = 0; o < 125; ++o) {
            const Ray ray{{origins[o % 5], origins[o / 5 % 5], origins[o / 25]},
                          {directions[d % 4], directions[d / 4 % 4], directions[d / 16]}};
            if (!isUsable(ray)) continue;
            const bool expected = touchesExactly(ray, -1, 1);
            EXPECT_EQ(enterOf(ray, box) != kNowhere, expected) << "direction " << d << ", origin " << o;
            plainlyWrong += touchesPlainly(ray, box) != expected;
            ++compared;
            touched += expected;
        }
    EXPECT_EQ(compared, 56 * 125);
    EXPECT_GT(touched, 1000);
    EXPECT_GT(plainlyWrong, 100); // 0 * infinity
}

// A triangle that fills its box from corner to corner, and rays at its corners: what hits the triangle touches the box.
TEST(RayVolumesTest, BoxesThatFitTightly) {
    Random random(1);
    long hits = 0, lost = 0, plainlyLost = 0;
    for (int i = 0; i < 400'000 * longRun(10); ++i) {
        const Triangle t{inCube(random, 1), inCube(random, 1), inCube(random, 1)};
        Box box;
        box.include(t);
        const dvec3 from = inCube(random, 3), target = i % 2 ? t.a : 0.5 * (t.b + t.c);
        const Ray ray{from, target - from};
        const ShearedRay sheared(ray);
        if (!intersect(sheared, t, sheared.farthest)) continue;
        ++hits;
        lost += VolumeRay(sheared).enter(box, sheared.farthest) == kNowhere;
        plainlyLost += !touchesPlainly(ray, box);
    }
    std::cout << hits << " hits, boxes missed: " << lost << ", without slack " << plainlyLost << "\n";
    EXPECT_GT(hits, 50'000);
    EXPECT_EQ(lost, 0);
    EXPECT_GT(plainlyLost, 0);
}

template <typename Number>
bool touchesBySchoolbook(const Ray& ray, const Ball& ball) {
    using Vector = glm::vec<3, Number>;
    const Vector f = Vector(ray.originCentred) - Vector(ball.centreCentred), d(ray.directionCentred);
    const Number a = glm::dot(d, d), b = glm::dot(f, d), r = static_cast<Number>(ball.radius);
    return b * b - a * (glm::dot(f, f) - r * r) >= 0;
}

/// How far the line passes the centre, with 64 bits of mantissa.
long double passes(const Ray& ray, const Ball& ball) {
    using Vector = glm::vec<3, long double>;
    const Vector f = Vector(ray.originCentred) - Vector(ball.centreCentred), d(ray.directionCentred);
    return glm::length(glm::cross(f, d)) / glm::length(d);
}

// A ball of radius 1 ever farther away, rays that graze it within and without.
TEST(RayVolumesTest, BallsFarAway) {
    for (const double away : {10.0, 1e2, 1e3, 1e4, 1e5, 1e7}) {
        Random random(2);
        long touched = 0, lost = 0, floatLost = 0, doubleLost = 0, kept = 0, passed = 0;
        for (int i = 0; i < 50'000 * longRun(10); ++i) {
            const dvec3 toBall = onSphere(random);
            const Ball ball{inCube(random, 1) + away * toBall, 1};
            const dvec3 aside = glm::normalize(glm::cross(toBall, onSphere(random)));
            // Within a share of 1e-9 of the rim; every fourth anywhere near it; every fourth just beside the ball.
            const double share = i % 4 == 0 ? number(random, 0.9, 1.1) : i % 4 == 1 ? 1.001 : 1 - 1e-9;
            Ray ray{inCube(random, 1), dvec3(0)};
            ray.directionCentred = (ball.centreCentred + share * aside - ray.originCentred) * number(random, 0.1, 10);
            const long double distance = passes(ray, ball);
            const bool found = enterOf(ray, ball) != kNowhere;
            if (distance <= 1) {
                ++touched;
                lost += !found;
                floatLost += !touchesBySchoolbook<float>(ray, ball);
                doubleLost += !touchesBySchoolbook<double>(ray, ball);
            } else if (distance > 1.0005L) {
                ++passed;
                kept += found;
            }
        }
        std::cout << "at " << away << ": " << touched << " touched, missed: " << lost << ", by b^2 - ac in float "
                  << floatLost << ", in double " << doubleLost << "; " << kept << " of " << passed
                  << " that pass by are kept\n";
        EXPECT_GT(touched, 20'000);
        EXPECT_EQ(lost, 0) << away;
        EXPECT_GT(passed, 5'000);
        EXPECT_EQ(kept, 0) << away; // the slack is far less than 0.0005
        EXPECT_GE(floatLost, away >= 1e4 ? touched / 100 : 0) << away;
        EXPECT_GE(doubleLost, away >= 1e5 ? touched / 100 : 0) << away;
    }
}

// Triangles in the ball around them, rays at their corners, which lie on it.
TEST(RayVolumesTest, BallsAroundTriangles) {
    Random random(3);
    long hits = 0, lost = 0, wrongEnter = 0;
    for (int i = 0; i < 100'000 * longRun(10); ++i) {
        const double size = std::pow(10.0, number(random, -6, 0));
        const dvec3 there = inCube(random, 1000);
        const std::vector<Triangle> all(
            1, {there + inCube(random, size), there + inCube(random, size), there + inCube(random, size)});
        const Ball ball = ballAround(all, std::vector<std::uint32_t>{0});
        const dvec3 from = i % 3 ? inCube(random, 1000) : there + inCube(random, size),
                    target = i % 2 ? all[0].a : all[0].b;
        const Ray ray{from, target - from};
        const ShearedRay sheared(ray);
        const auto hit = intersect(sheared, all[0], sheared.farthest);
        if (!hit) continue;
        ++hits;
        const double enter = enterOf(ray, ball);
        lost += enter == kNowhere;
        wrongEnter += enter > hit->reach * (1 + 1e-6);
    }
    EXPECT_GT(hits, 20'000);
    EXPECT_EQ(lost, 0);
    EXPECT_EQ(wrongEnter, 0);
}

TEST(RayVolumesTest, NothingIsTouchedBehindTheRayOrBeyondItsEnd) {
    const Box box{dvec3(-1), dvec3(1)};
    const Ball ball{dvec3(0), 1};
    const auto touches = [&](const dvec3& from, const dvec3& toward, double nearest, double farthest) {
        const Ray ray{from, toward, nearest, farthest};
        EXPECT_EQ(enterOf(ray, box) != kNowhere, enterOf(ray, ball) != kNowhere);
        return enterOf(ray, box) != kNowhere;
    };
    const double inf = std::numeric_limits<double>::infinity();
    EXPECT_TRUE(touches({-3, 0, 0}, {1, 0, 0}, 0, inf));
    EXPECT_FALSE(touches({3, 0, 0}, {1, 0, 0}, 0, inf));
    EXPECT_FALSE(touches({-3, 0, 0}, {1, 0, 0}, 0, 1.9));
    EXPECT_TRUE(touches({-3, 0, 0}, {1, 0, 0}, 0, 2.1));
    EXPECT_FALSE(touches({-3, 0, 0}, {1, 0, 0}, 4.1, inf));
    EXPECT_TRUE(touches({-3, 0, 0}, {1, 0, 0}, 3.9, inf));
    EXPECT_TRUE(touches({0, 0, 0}, {0, 1, 0}, 0, 0.1)); // from within
}

} // namespace
} // namespace shadowlab::trace
