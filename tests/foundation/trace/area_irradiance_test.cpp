// What an area light adds behind an edge, against closed forms, in which the share of its area would be the wrong answer.
// SPDX-License-Identifier: MIT
#include "techniques/foundation/trace/area/area_visibility.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>

#include "tests/support/area_lights.h"
#include "tests/support/scenes.h"

namespace shadowlab::trace {
namespace {

using testing::rectLight, testing::sphereLight, testing::surfacePointAt, testing::tracerOf, testing::triangleSoup;

// Closed forms in double, of numbers up to 4 pi.
constexpr double kRounding = 1e-13;

const dvec3 kUp(0, 1, 0);

scene::Snapshot with(scene::Scene scene, scene::Light light) {
    scene.lights = {std::move(light)};
    return testing::snapshot(std::move(scene));
}

/// The edge of a half plane at a height of 2 over x = 0; what is at smaller x is behind it.
scene::Scene halfPlane() {
    scene::Scene scene = testing::floorScene();
    testing::addObject(scene,
                       triangleSoup({{-64, 2, -64}, {0, 2, -64}, {0, 2, 64}, {-64, 2, -64}, {0, 2, 64}, {-64, 2, 64}}));
    return scene;
}

AreaIrradiance irradianceAt(const AreaVisibility& area, const SceneTracer& tracer, const dvec3& positionWorld,
                            const dvec3& normal = kUp) {
    const SurfacePoint point = surfacePointAt(tracer, 0, positionWorld);
    AreaIrradiance answer;
    area.irradiances({&point, 1}, {&normal, 1}, {&answer, 1});
    return answer;
}

/// Irradiance from a parallel rectangle one corner of which is straight above, at a distance of 1, with the sides a and b
/// (J. R. Howell's catalogue of configuration factors). Odd in both.
double cornerFactor(double a, double b) {
    const double rootA = std::sqrt(1 + a * a), rootB = std::sqrt(1 + b * b);
    return (a / rootA * std::atan(b / rootA) + b / rootB * std::atan(a / rootB)) / (2 * M_PI);
}

/// Of the part of the panel beyond x = from, seen from (x, 0, 0).
double panelFactor(double x, double from) {
    const auto upTo = [x](double end) { return 2 * cornerFactor((end - x) / 4, 0.5 / 4); };
    return upTo(0.5) - upTo(std::clamp(from, -0.5, 0.5));
}

// A panel of 1 x 1 m at a height of 4: from (x, 0, 0) what lies beyond -x is seen of it. The table's columns have ten and eight
// digits.
TEST(AreaIrradiance, HalfPlaneUnderARect) {
    const auto snapshot = with(halfPlane(), rectLight({0, 4, 0}, {1, 0, 0}, {0, 0, 1}));
    const SceneTracer tracer = tracerOf(snapshot);
    const AreaVisibility area(tracer, 0);
    struct Row {
        double x, unshadowed, irradiance, share, visible;
    };
    constexpr std::array<Row, 9> kTable = {{{-.375, .01916402455, .002270713415, .11848834, .125},
                                            {-.25, .01934344575, .004689270598, .24242168, .25},
                                            {-.125, .01945228528, .007201447076, .37021085, .375},
                                            {0, .01948876505, .009744382526, .5, .5},
                                            {.125, .01945228528, .0122508382, .62978915, .625},
                                            {.25, .01934344575, .01465417515, .75757832, .75},
                                            {.375, .01916402455, .01689331114, .88151166, .875},
                                            {.5, .01891691532, .01891691532, 1, 1},
                                            {1, .01734206797, .01734206797, 1, 1}}};
    double naiveLargest = 0;
    for (const Row& row : kTable) {
        const AreaIrradiance found = irradianceAt(area, tracer, {row.x, 0, 0});
        EXPECT_NEAR(found.unshadowed, row.unshadowed, 1e-11) << row.x;
        EXPECT_NEAR(found.irradiance, row.irradiance, 1e-11) << row.x;
        EXPECT_NEAR(found.irradiance / found.unshadowed, row.share, 1e-8) << row.x;
        EXPECT_NEAR(found.visible, row.visible, kRounding) << row.x;
        naiveLargest = std::max(naiveLargest, std::abs(found.visible - row.share));
    }
    EXPECT_GT(naiveLargest, 7e-3) << "the share of area, without cosines and distances, is another one";
    std::mt19937 numbers(1);
    std::uniform_real_distribution<double> place(-0.7, 0.7);
    for (int i = 0; i < 200; ++i) {
        const double x = place(numbers);
        const AreaIrradiance found = irradianceAt(area, tracer, {x, 0, 0});
        EXPECT_NEAR(found.irradiance, panelFactor(x, -x), kRounding) << x;
        EXPECT_NEAR(found.unshadowed, panelFactor(x, -1), kRounding) << x;
    }
}

/// The part of a ball that a plane through the point leaves, `seenSide` being its unit normal. `a`: unit, to the middle. It is
/// bounded by an arc of the ball's rim and one of a great circle.
double ballFactor(const dvec3& a, double sine, const dvec3& seenSide, const dvec3& normal) {
    const double cosine = std::sqrt(1 - sine * sine), s = glm::dot(seenSide, a);
    if (s >= sine) return sine * sine * glm::dot(normal, a);
    if (s <= -sine) return 0;
    const dvec3 u = glm::normalize(seenSide - s * a), v = glm::cross(a, u);
    const double cosPhi = -cosine * s / (sine * std::sqrt(1 - s * s)), sinPhi = std::sqrt(1 - cosPhi * cosPhi);
    const dvec3 plus = cosine * a + sine * (cosPhi * u + sinPhi * v);
    const dvec3 minus = cosine * a + sine * (cosPhi * u - sinPhi * v);
    const dvec3 across = glm::cross(plus, minus);
    const double between = std::atan2(glm::length(across), glm::dot(plus, minus));
    return glm::dot(normal, 2 * std::acos(cosPhi) * sine * sine * a - 2 * sine * cosine * sinPhi * u +
                                between * glm::normalize(across)) /
           (2 * M_PI);
}

TEST(AreaIrradiance, EdgeBeforeASphere) {
    const auto snapshot = with(halfPlane(), sphereLight({0, 4, 0}, 0.5));
    const SceneTracer tracer = tracerOf(snapshot);
    const AreaVisibility area(tracer, 0);
    struct Row {
        double x, share;
    };
    // Given to six to eight digits.
    constexpr std::array<Row, 7> kTable = {{{-.5, .0030578889},
                                            {-.3, .14523928},
                                            {-.1, .373371},
                                            {0, .5},
                                            {.1, .626629},
                                            {.3, .85476072},
                                            {.5, .99694211}}};
    for (const Row& row : kTable) {
        const AreaIrradiance found = irradianceAt(area, tracer, {row.x, 0, 0});
        EXPECT_NEAR(found.irradiance / found.unshadowed, row.share, 5e-7) << row.x;
    }
    EXPECT_NEAR(irradianceAt(area, tracer, {.3, 0, 0}).irradiance, .01324373521, 1e-11);
    EXPECT_NEAR(irradianceAt(area, tracer, {.5, 0, 0}).irradiance, .01521913233, 1e-11);
    EXPECT_NEAR(irradianceAt(area, tracer, {0, 0, 0}).unshadowed, .015625, kRounding);

    // Shading normals up to 0.6 rad from the triangle's: the ball stays above their horizon.
    std::mt19937 numbers(2);
    std::uniform_real_distribution<double> place(-0.55, 0.55), tilt(-0.4, 0.4);
    int partly = 0;
    double naiveLargest = 0;
    for (int i = 0; i < 200; ++i) {
        const double x = place(numbers), distance = std::hypot(x, 4);
        const dvec3 normal = glm::normalize(dvec3(tilt(numbers), 1, tilt(numbers)));
        const dvec3 toMiddle = dvec3(-x, 4, 0) / distance, seenSide = glm::normalize(dvec3(2, x, 0));
        const AreaIrradiance found = irradianceAt(area, tracer, {x, 0, 0}, normal);
        const double whole = 0.25 / (distance * distance) * glm::dot(normal, toMiddle);
        const double expected = ballFactor(toMiddle, 0.5 / distance, seenSide, normal);
        EXPECT_NEAR(found.irradiance, expected, kRounding) << x;
        EXPECT_NEAR(found.unshadowed, whole, kRounding) << x;
        partly += expected > 0 && expected < whole;
        naiveLargest = std::max(naiveLargest, std::abs(found.visible - expected / whole));
    }
    EXPECT_GT(partly, 150);
    EXPECT_GT(naiveLargest, 1e-3) << "the share of area, without cosines and distances, is another one";
}

// A light that the horizon of the shading normal cuts counts only above it; so does what lies above the triangle's own plane.
TEST(AreaIrradiance, AboveBothHorizons) {
    scene::Scene scene = testing::floorScene();
    scene.objects[0].castsShadow = false;
    // A ball, half of which is below the floor. The other half is above the horizon of each of these normals.
    const auto ball = with(scene, sphereLight({-2, 1e-13, 0}, 0.5));
    const SceneTracer tracer = tracerOf(ball);
    const AreaVisibility area(tracer, 0);
    const dvec3 toMiddle(-1, 0, 0);
    for (const dvec3& normal : {kUp, glm::normalize(dvec3(-0.125, 1, 0.25)), glm::normalize(dvec3(-1, 1, 0))}) {
        const AreaIrradiance found = irradianceAt(area, tracer, {1, 0, 0}, normal);
        EXPECT_NEAR(found.irradiance, ballFactor(toMiddle, 0.5 / 3, kUp, normal),
                    1e-12); // the middle is 1e-13 too high
        EXPECT_NEAR(found.irradiance, found.unshadowed, kRounding);
        EXPECT_NEAR(found.visible, 0.5, 1e-11);
    }
    // Seen by a normal that leans so far that only a part of the upper half counts: a panel straight above, 2 x 2 m at a height
    // of 1, by (1, 0, 0) the half at positive x. Its factor is that of a perpendicular rectangle, twice.
    const auto panel = with(scene, rectLight({0, 1, 0}, {2, 0, 0}, {0, 0, 2}));
    const SceneTracer panelTracer = tracerOf(panel);
    const AreaIrradiance aside = irradianceAt(AreaVisibility(panelTracer, 0), panelTracer, {0, 0, 0}, {1, 0, 0});
    // At a corner of the common edge line, at distance 1, width 1, height 1.
    const double quarter = (std::atan(1.0) - std::atan(1 / std::sqrt(2.0)) / std::sqrt(2.0)) / (2 * M_PI);
    EXPECT_NEAR(quarter, .0557341970026, 1e-13);
    EXPECT_NEAR(aside.irradiance, 2 * quarter, kRounding);
    EXPECT_NEAR(aside.visible, 1, kRounding);
}

// A light of which the centre has set, and a part has not, still gives its light; the share, by the centre's gate, is 0.
TEST(AreaIrradiance, WhatIsLeftOfALightThatSets) {
    scene::Scene scene = testing::floorScene();
    scene.objects[0].castsShadow = false;
    int compared = 0;
    for (const double height : {-0.49, -0.4, -0.2, -0.01, 0.01, 0.2, 0.4, 0.49, 0.6}) {
        const auto ball = with(scene, sphereLight({-2, height, 0}, 0.5));
        const SceneTracer tracer = tracerOf(ball);
        const dvec3 toMiddle = dvec3(-3, height, 0);
        const double sine = 0.5 / glm::length(toMiddle);
        const AreaIrradiance found = irradianceAt(AreaVisibility(tracer, 0), tracer, {1, 0, 0});
        EXPECT_NEAR(found.irradiance, ballFactor(glm::normalize(toMiddle), sine, kUp, kUp), kRounding) << height;
        EXPECT_GT(found.irradiance, 0) << height;
        EXPECT_EQ(found.visible > 0, height > 0) << height;

        // A panel of 1 x 1 m that stands upright and faces the point: of it a wall of that width and the height that is left is seen.
        const auto panel = with(scene, rectLight({-2, height, 0}, {0, 1, 0}, {0, 0, 1}));
        const SceneTracer panelTracer = tracerOf(panel);
        const auto upTo = [](double top) { // twice the factor of a perpendicular rectangle with a corner on the floor before the point
            const double far = std::hypot(top, 3);
            return (std::atan(0.5 / 3) - 3 / far * std::atan(0.5 / far)) / M_PI;
        };
        const AreaIrradiance upright = irradianceAt(AreaVisibility(panelTracer, 0), panelTracer, {1, 0, 0});
        EXPECT_NEAR(upright.irradiance, upTo(height + 0.5) - upTo(std::max(0.0, height - 0.5)), kRounding) << height;
        EXPECT_EQ(upright.visible > 0, height > 0) << height;
        ++compared;
    }
    EXPECT_EQ(compared, 9);
    for (const double height : {-0.6, -0.5 - 1e-9}) { // it has set
        const auto ball = with(scene, sphereLight({-2, height, 0}, 0.5));
        const SceneTracer tracer = tracerOf(ball);
        EXPECT_EQ(irradianceAt(AreaVisibility(tracer, 0), tracer, {1, 0, 0}).irradiance, 0);
    }
}

// A panel let into the floor lights nothing of it, nor does one that lies on it face down.
TEST(AreaIrradiance, NothingInThePlaneOfAPanelIsLit) {
    for (const double side : {1.0, -1.0}) {
        const auto panel = with(testing::floorScene(), rectLight({0, 0, 0}, {1, 0, 0}, {0, 0, side}));
        const SceneTracer tracer = tracerOf(panel);
        const AreaVisibility area(tracer, 0);
        for (const dvec3& place : {dvec3(0), dvec3(0.3, 0, 0.2), dvec3(0.5, 0, 0.5), dvec3(3, 0, 1)}) {
            const AreaIrradiance found = irradianceAt(area, tracer, place);
            EXPECT_EQ(found.irradiance, 0) << place.x;
            EXPECT_EQ(found.visible, 0) << place.x;
        }
    }
}

// Neighbours are asked together, by a search that is parted: every answer is the one that a point gets alone.
TEST(AreaIrradiance, ManyPointsAtOnce) {
    for (const scene::Light& light :
         {rectLight({2, 4, 2.5}, {1, 0, -1}, {-0.5, -1.2, -0.5}), sphereLight({2, 4, 2.5}, 0.6)}) {
        const auto snapshot = with(testing::simpleScene(), light);
        const SceneTracer tracer = tracerOf(snapshot);
        const AreaVisibility area(tracer, 0);
        const EyeRays rays = tracer.eyeRays(snapshot->camera, ivec2(32));
        std::vector<SurfacePoint> points(32 * 32);
        tracer.eyePoints(rays, {0, 0}, ivec2(32), dvec2(0.5), points);
        const std::vector<dvec3> normals(points.size(), glm::normalize(dvec3(0.25, 1, 0.125)));
        std::vector<AreaIrradiance> together(points.size());
        area.irradiances(points, normals, together);
        int partly = 0;
        for (std::size_t i = 0; i < points.size(); ++i) {
            AreaIrradiance alone;
            area.irradiances({&points[i], 1}, {&normals[i], 1}, {&alone, 1});
            EXPECT_NEAR(together[i].irradiance, alone.irradiance, kRounding) << i;
            EXPECT_NEAR(together[i].unshadowed, alone.unshadowed, kRounding) << i;
            EXPECT_NEAR(together[i].visible, area.share(points[i]), 1e-12) << i;
            EXPECT_LE(together[i].irradiance, together[i].unshadowed) << i;
            partly += together[i].irradiance > 0 && together[i].irradiance < 0.999 * together[i].unshadowed;
        }
        EXPECT_GT(partly, 20);
    }
}

TEST(AreaIrradiance, TheGatesAreThoseOfTheShare) {
    scene::Scene scene = halfPlane();
    const scene::Light panel = rectLight({0, 4, 0}, {1, 0, 0}, {0, 0, 1});
    scene.objects[0].receivesShadow = false;
    const auto unshadowed = with(scene, panel);
    const SceneTracer tracer = tracerOf(unshadowed);
    const AreaIrradiance all = irradianceAt(AreaVisibility(tracer, 0), tracer, {-0.25, 0, 0});
    EXPECT_EQ(all.visible, 1);
    EXPECT_EQ(all.irradiance, all.unshadowed);
    EXPECT_NEAR(all.irradiance, panelFactor(-0.25, -1), kRounding);
    // From behind, and within.
    const auto behind = with(scene, rectLight({0, 4, 0}, {0, 0, 1}, {1, 0, 0}));
    const SceneTracer behindTracer = tracerOf(behind);
    EXPECT_EQ(irradianceAt(AreaVisibility(behindTracer, 0), behindTracer, {0.5, 0, 0}).unshadowed, 0);
    const auto within = with(scene, sphereLight({0, 0.25, 0}, 0.5));
    const SceneTracer withinTracer = tracerOf(within);
    EXPECT_EQ(irradianceAt(AreaVisibility(withinTracer, 0), withinTracer, {0, 0, 0}).unshadowed, 0);
}

} // namespace
} // namespace shadowlab::trace
