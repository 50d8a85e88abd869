// Sphere lights that something cuts: sunk into a wall they are seen as far as the circle in which the wall's plane cuts them.
// SPDX-License-Identifier: MIT
#include "techniques/foundation/trace/area/sphere_cuts.h"

#include <gtest/gtest.h>

#include <cmath>
#include <iostream>

#include "techniques/foundation/scene/model/shapes.h"
#include "techniques/foundation/trace/area/area_visibility.h"
#include "tests/support/area_lights.h"
#include "tests/support/scenes.h"

namespace shadowlab::trace {
namespace {

// Chords lie off the circle by 0.3 % of its radius, now inside and now outside, and their sum is right. At each end of an arc half a chord's
// worth is left, that is 0.003 * 0.2 / 4 of the square of the radius; two ends, of an area of pi.
constexpr double kChords = 1e-4;

const dvec3 kLamp(0, 2, 0);
constexpr double kRadius = 0.5;

/// A lamp half sunk into a sheet, which is as wide as anything: of the lamp x > 0 is to be seen from the floor before it.
scene::Snapshot halfSunk() {
    scene::Scene scene = testing::floorScene();
    testing::addObject(scene, testing::triangleSoup({{0, 0, -64}, {0, 64, -64}, {0, 64, 64}, {0, 0, -64}, {0, 64, 64}, {0, 0, 64}}));
    scene.lights = {testing::sphereLight(kLamp, kRadius)};
    return testing::snapshot(std::move(scene));
}

/// Shares of the disc that is seen. In units of the radius, from a distance d, the half ball where n * q > 0: a way to the place (u, v) of the
/// disc enters where n_x rho u + n_z (w + 1/d) = 0 at its border, with u^2 + v^2 + w^2 = 1. That is again a circle on a ball, seen from infinitely far: an ellipse.
struct Halves {
    double seen;
    double beforeDisc; ///< what would be seen if the sheet cut the disc, not the ball
};

double segment(double cosine) { return std::acos(cosine) - cosine * std::sqrt(1 - cosine * cosine); }

Halves halvesFrom(const dvec3& positionWorld) {
    const dvec3 way = (positionWorld - kLamp) / kRadius;
    const double d = glm::length(way), rho = std::sqrt(1 - 1 / (d * d)), nz = way.x / d, nx = std::sqrt(1 - nz * nz);
    const double border = -nz / (d * nx * rho); // u, where it meets the rim
    if (border <= -1) return {1, 1};
    const double length = std::hypot(nx * rho, nz), mx = nx * rho / length, mz = nz / length, h = nz / d / length;
    const double b = std::sqrt(1 - h * h), a = b * mz;
    const double beyondLine = segment(-border), withinEllipse = a * b * segment((-h * mx - border) / a);
    return {1 - (beyondLine - withinEllipse) / M_PI, 1 - beyondLine / M_PI};
}

/// Sums over the disc, over `steps` rings of twice as many places. isSeen(way, enters): whether one sees the ball along a way, which enters it at
/// a share of the way.
struct Summed {
    double share = 0, irradiance = 0; ///< over pi times the radiance
};

template <typename IsSeen>
Summed summedOver(const dvec3& positionWorld, const dvec3& normal, int steps, const IsSeen& isSeen) {
    const dvec3 toLamp = kLamp - positionWorld;
    const double distance = glm::length(toLamp), nearer = 1 - std::pow(kRadius / distance, 2), rim = kRadius * std::sqrt(nearer);
    const dvec3 axis = toLamp / distance, aside = glm::normalize(glm::cross(axis, dvec3(0.3, 0.2, 0.9))), across = glm::cross(axis, aside);
    Summed sum;
    for (int ring = 0; ring < steps; ++ring)
        for (int i = 0; i < 2 * steps; ++i) {
            const double from = rim * (ring + 0.5) / steps, angle = M_PI * (i + 0.5) / steps;
            const dvec3 way = nearer * toLamp + from * (std::cos(angle) * aside + std::sin(angle) * across);
            const double along = glm::dot(way, toLamp), squared = glm::dot(way, way);
            const double enters = (along - std::sqrt(along * along - squared * (distance * distance - kRadius * kRadius))) / squared;
            if (!isSeen(way, enters)) continue;
            sum.share += from;
            sum.irradiance += glm::dot(normal, way) * glm::dot(axis, way) / (squared * squared) * from;
        }
    const double place = rim / steps / steps; // the ring's width and the step of the angle, over pi
    return {sum.share * place / (rim * rim), sum.irradiance * place};
}

/// Holds what points of the floor see of the lamp against sums over its disc; isSeen(position, way, enters). Returns how many see a part of it.
template <typename IsSeen>
int compareWithSums(const scene::Snapshot& snapshot, const IsSeen& isSeen) {
    const SceneTracer tracer = testing::tracerOf(snapshot);
    const AreaVisibility area(tracer, 0);
    int parts = 0;
    for (const double x : {1e-3, 0.05, 0.3, 1.0, 3.5})
        for (const double z : {1e-3, 0.1, 0.7, 2.0}) {
            const dvec3 at(x, 0, z), up(0, 1, 0);
            const SurfacePoint point = testing::surfacePointAt(tracer, 0, at);
            const Summed summed = summedOver(at, up, 400, [&](const dvec3& way, double enters) { return isSeen(at, way, enters); });
            AreaIrradiance found;
            area.irradiances({&point, 1}, {&up, 1}, {&found, 1});
            // A sum is wrong by a thousandth of a ring along the border; where that is two walls, of two.
            EXPECT_NEAR(found.visible, summed.share, 1e-3) << x << ' ' << z;
            EXPECT_NEAR(area.share(point), found.visible, 1e-12) << x << ' ' << z;
            EXPECT_NEAR(found.irradiance, summed.irradiance, 1e-3 * found.unshadowed) << x << ' ' << z;
            parts += found.visible > 0.01 && found.visible < 0.99;
        }
    return parts;
}

/// A rectangle of a mesh of its own.
void addRect(scene::Scene& scene, const dvec3& corner, const dvec3& edgeU, const dvec3& edgeV) {
    const dvec3 u = corner + edgeU, both = u + edgeV, v = corner + edgeV;
    testing::addObject(scene, testing::triangleSoup({corner, u, both, corner, both, v}));
}

scene::Scene lampOverFloor() {
    scene::Scene scene = testing::floorScene();
    scene.lights = {testing::sphereLight(kLamp, kRadius)};
    return scene;
}

TEST(SunkenSphere, HalfABallIsSeenAsFarAsItsCircle) {
    const auto snapshot = halfSunk();
    const SceneTracer tracer = testing::tracerOf(snapshot);
    const AreaVisibility area(tracer, 0);
    int cut = 0;
    double worst = 0, naiveWorst = 0;
    for (const double x : {1e-3, 0.1, 0.3, 0.6, 1.0, 2.0, 3.5})
        for (const double z : {0.0, 0.7, 2.0, 3.5}) {
            const dvec3 at(x, 0, z);
            const SurfacePoint point = testing::surfacePointAt(tracer, 0, at);
            const Halves expected = halvesFrom(at);
            EXPECT_NEAR(area.share(point), expected.seen, kChords) << x << ' ' << z;
            AreaIrradiance found;
            const dvec3 up(0, 1, 0);
            area.irradiances({&point, 1}, {&up, 1}, {&found, 1});
            EXPECT_NEAR(found.visible, expected.seen, kChords);
            // The sum is wrong by a thousandth of a ring along the border.
            const Summed summed = summedOver(at, up, 400, [&](const dvec3& way, double enters) { return at.x + enters * way.x >= 0; });
            EXPECT_NEAR(found.irradiance, summed.irradiance, 5e-4 * found.unshadowed) << x << ' ' << z;
            cut += expected.seen < 1;
            worst = std::max(worst, std::abs(found.visible - expected.seen));
            naiveWorst = std::max(naiveWorst, expected.seen - expected.beforeDisc);
        }
    std::cout << cut << " points see a part, wrong by " << worst << " at most; before the disc " << naiveWorst << "\n";
    EXPECT_GT(cut, 20);
    EXPECT_GT(naiveWorst, 0.1) << "what lies before the disc is as much";
}

// The sheet's other side sees the other half: together they are one ball.
TEST(SunkenSphere, RaysAgreeFromBothSides) {
    const auto snapshot = halfSunk();
    const SceneTracer tracer = testing::tracerOf(snapshot);
    const AreaVisibility area(tracer, 0);
    for (const double x : {-2.0, -0.5, 0.5, 2.0}) {
        const SurfacePoint point = testing::surfacePointAt(tracer, 0, {x, 0, 1.5});
        const double share = area.share(point);
        EXPECT_GT(share, 0.4);
        EXPECT_LT(share, 1);
        // Jittered rays stay below four standard deviations of random ones.
        EXPECT_NEAR(share, testing::sampledShare(tracer, point, 0, 128), 4 * 0.5 / 128) << x;
        EXPECT_NEAR(share, area.share(testing::surfacePointAt(tracer, 0, {-x, 0, 1.5})), 1e-12);
    }
}

// In a corner of a room: before all walls one sees a convex part of the ball, bounded by chords in several planes.
TEST(SunkenSphere, InTheCornerOfARoomOneOfEightPartsIsSeen) {
    scene::Scene scene = lampOverFloor();
    addRect(scene, {0, 0, 0}, {0, 2, 0}, {0, 0, 8});
    addRect(scene, {0, 0, 0}, {8, 0, 0}, {0, 2, 0});
    addRect(scene, {0, 2, 0}, {8, 0, 0}, {0, 0, 8});
    const int parts = compareWithSums(testing::snapshot(std::move(scene)), [](const dvec3& at, const dvec3& way, double enters) {
        const dvec3 place = at + enters * way;
        return place.x >= 0 && place.z >= 0 && place.y <= 2;
    });
    EXPECT_GT(parts, 15);
}

// The edge of a body that goes into the ball: what is seen before its two faces is not convex.
TEST(SunkenSphere, AroundAnEdgeThreeOfFourPartsAreSeen) {
    scene::Scene scene = lampOverFloor();
    addRect(scene, {0, 0, -8}, {0, 8, 0}, {0, 0, 8});
    addRect(scene, {-8, 0, 0}, {8, 0, 0}, {0, 8, 0});
    const int parts = compareWithSums(testing::snapshot(std::move(scene)), [](const dvec3& at, const dvec3& way, double enters) {
        const dvec3 place = at + enters * way;
        return place.x >= 0 || place.z >= 0;
    });
    EXPECT_GT(parts, 4);
}

// A wall thinner than the ball: its far side cuts the ball, too, and what is beyond is not seen.
TEST(SunkenSphere, AThinWallIsSeenAsAnyOther) {
    scene::Scene scene = lampOverFloor();
    addRect(scene, {0, 0, -64}, {0, 64, 0}, {0, 0, 128});
    addRect(scene, {-0.1, 0, -64}, {0, 64, 0}, {0, 0, 128});
    const int parts = compareWithSums(testing::snapshot(std::move(scene)), [](const dvec3& at, const dvec3& way, double enters) { return at.x + enters * way.x >= 0; });
    EXPECT_GT(parts, 15);
}

// A wall that ends, and a shelf before the lamp, which shows or hides the border between the two.
TEST(SunkenSphere, WhatStandsBeforeItHidesMore) {
    scene::Scene scene = lampOverFloor();
    addRect(scene, {0, 0, -8}, {0, 2.2, 0}, {0, 0, 16});
    addRect(scene, {-8, 1, -8}, {16, 0, 0}, {0, 0, 8.35});
    const int parts = compareWithSums(testing::snapshot(std::move(scene)), [](const dvec3& at, const dvec3& way, double enters) {
        const dvec3 atWall = at - at.x / way.x * way, atShelf = at + 1 / way.y * way;
        const bool isBeforeWall = at.x + enters * way.x >= 0 || atWall.y > 2.2;
        return isBeforeWall && atShelf.z > 0.35;
    });
    EXPECT_GT(parts, 8);
}

// What is wholly within it hides nothing.
TEST(SunkenSphere, ABodyWithinHidesNothing) {
    scene::Scene scene = testing::floorScene();
    testing::addObject(scene, scene::makeSphere(0.3, 32), testing::translation(kLamp));
    scene.lights = {testing::sphereLight(kLamp, kRadius)};
    const auto snapshot = testing::snapshot(std::move(scene));
    const SceneTracer tracer = testing::tracerOf(snapshot);
    const AreaVisibility area(tracer, 0);
    for (const double x : {0.0, 0.3, 1.0, 3.0}) EXPECT_EQ(area.share(testing::surfacePointAt(tracer, 0, {x, 0, 0.25})), 1) << x;
}

/// Twice the area that the chords enclose, seen from the middle.
double enclosedTwice(const SphereCuts& cuts, const dvec3& middle) {
    double sum = 0;
    for (const SphereCut& cut : cuts.chords()) sum += glm::length(glm::cross(cut.firstCentred - middle, cut.secondCentred - middle));
    return sum;
}

TEST(SunkenSphere, ChordsEncloseTheAreaOfTheCircle) {
    const dvec3 centre(0.1, 0.2, 0.3);
    const auto cutsOf = [&](std::initializer_list<Triangle> triangles) {
        SphereCuts cuts(centre, 1);
        for (const Triangle& triangle : triangles) cuts.add(triangle, 7);
        return cuts;
    };
    const dvec3 middle(0.1, 0.8, 0.3); // of the plane's circle, whose radius is 0.8
    const double twice = 2 * M_PI * 0.64;
    const auto around = cutsOf({{{-9, 0.8, -9}, {0, 0.8, 20}, {9, 0.8, -9}}});
    EXPECT_EQ(around.chords().size(), 32u);
    EXPECT_NEAR(enclosedTwice(around, middle), twice, 1e-12);
    EXPECT_EQ(around.chords().front().primitive, 7u);
    // Two triangles of a quad, whose diagonal goes through the circle; and as many as a fan has.
    const auto halves = cutsOf({{{-9, 0.8, -9}, {9, 0.8, 9}, {9, 0.8, -9}}, {{-9, 0.8, -9}, {-9, 0.8, 9}, {9, 0.8, 9}}});
    EXPECT_NEAR(enclosedTwice(halves, middle), twice, 1e-12);
    EXPECT_GT(halves.chords().size(), 32u);
    // A corner in the circle's middle is a quarter of it.
    EXPECT_NEAR(enclosedTwice(cutsOf({{middle, {0.1, 0.8, 9}, {9, 0.8, 0.3}}}), middle), twice / 4, 1e-12);
    // It passes the sphere, touches it, lies within it, or is no triangle.
    EXPECT_TRUE(cutsOf({{{-9, 1.3, -9}, {0, 1.3, 20}, {9, 1.3, -9}}}).chords().empty());
    EXPECT_TRUE(cutsOf({{{-9, 1.2, -9}, {0, 1.2, 20}, {9, 1.2, -9}}}).chords().empty());
    EXPECT_TRUE(cutsOf({{{0, 0.8, 0}, {0.1, 0.8, 0}, {0.1, 0.8, 0.1}}}).chords().empty());
    EXPECT_TRUE(cutsOf({{{0, 0.2, 0}, {1, 0.2, 0}, {2, 0.2, 0}}}).chords().empty());
}

} // namespace
} // namespace shadowlab::trace
