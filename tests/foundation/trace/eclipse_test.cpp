// A ball before a ball of light: what two caps of directions have in common, and where the umbra and the penumbra end.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "techniques/foundation/trace/area/area_visibility.h"
#include "tests/support/area_lights.h"
#include "tests/support/scenes.h"

namespace shadowlab::trace {
namespace {

using testing::sphereLight, testing::surfacePointAt, testing::tracerOf;

/// All directions within an angle of an axis.
struct Cap {
    dvec3 axis;
    double angle;
};

/// Around what a ball's cap shows of it, the closed integral of r x dr along the arc that is within the other's.
dvec3 arcWithin(const Cap& cap, const Cap& other) {
    const double between = std::atan2(glm::length(glm::cross(cap.axis, other.axis)), glm::dot(cap.axis, other.axis));
    const double cosHalf =
        (std::cos(other.angle) - std::cos(between) * std::cos(cap.angle)) / (std::sin(between) * std::sin(cap.angle));
    const double half = std::acos(cosHalf), sine = std::sin(cap.angle), cosine = std::cos(cap.angle);
    const dvec3 u = glm::normalize(other.axis - std::cos(between) * cap.axis);
    return 2 * half * sine * sine * cap.axis - 2 * sine * cosine * std::sin(half) * u;
}

/// A disc that fills the cap from a point, at that distance: a fan of many triangles, the first corner in the direction that
/// is given. Each covers as much as its part of the disc.
scene::Mesh discBefore(const dvec3& pointWorld, const Cap& cap, double distance, const dvec3& firstCorner, int sides) {
    const double circumradius = std::sqrt(2 * M_PI / (sides * std::sin(2 * M_PI / sides)));
    const dvec3 u = glm::normalize(firstCorner - glm::dot(firstCorner, cap.axis) * cap.axis);
    const dvec3 v = glm::cross(cap.axis, u), middle = pointWorld + distance * cap.axis;
    const auto corner = [&](int i) {
        const double turn = 2 * M_PI * (i % sides) / sides;
        return middle + distance * std::tan(cap.angle) * circumradius * (std::cos(turn) * u + std::sin(turn) * v);
    };
    std::vector<dvec3> corners;
    for (int i = 0; i < sides; ++i)
        corners.insert(corners.end(), {middle, corner(i), corner(i + 1)});
    return testing::triangleSoup(corners);
}

AreaIrradiance behind(scene::Mesh occluder, const scene::Light& light, const dvec3& pointWorld, const dvec3& normal) {
    scene::Scene scene = testing::floorScene();
    testing::addObject(scene, std::move(occluder));
    scene.lights = {light};
    const auto snapshot = testing::snapshot(std::move(scene));
    const SceneTracer tracer = tracerOf(snapshot);
    const SurfacePoint point = surfacePointAt(tracer, 0, pointWorld);
    AreaIrradiance answer;
    AreaVisibility(tracer, 0).irradiances({&point, 1}, {&normal, 1}, {&answer, 1});
    return answer;
}

TEST(Eclipse, WhatTwoCapsHaveInCommon) {
    struct Case {
        double light, occluder, between;
    };
    double naiveLargest = 0;
    for (const Case& angles :
         {Case{.2, .15, .1}, Case{.2, .15, .2}, Case{.2, .3, .25}, Case{.3, .3, .3}, Case{.6, .2, .7}})
        for (const double tilt : {0.0, 0.4}) { // of the light, from straight above
            const dvec3 point(0.25, 0, 0.5), normal = glm::normalize(dvec3(0.25, 1, -0.125));
            const dvec3 towardLight(std::sin(tilt), std::cos(tilt), 0), aside = glm::vec3(0, 0, 1);
            const Cap light{towardLight, angles.light};
            const Cap occluder{std::cos(angles.between) * towardLight + std::sin(angles.between) * aside,
                               angles.occluder};
            const AreaIrradiance found =
                behind(discBefore(point, occluder, 2, aside, 2048),
                       sphereLight(point + 8.0 * towardLight, 8 * std::sin(angles.light)), point, normal);
            const double whole = std::pow(std::sin(angles.light), 2) * glm::dot(normal, towardLight);
            const double hidden =
                glm::dot(normal, arcWithin(light, occluder) + arcWithin(occluder, light)) / (2 * M_PI);
            EXPECT_NEAR(found.unshadowed, whole, 1e-13);
            // The occluder's corners are stored in float, each rounded by up to 6e-8 of a metre or two; over some thousand of
            // them that averages out. Its polygon of equal area is as good as the circle to 1e-10.
            EXPECT_NEAR(found.irradiance, whole - hidden, 1e-8) << angles.between;
            EXPECT_GT(hidden, 1e-3);
            naiveLargest = std::max(naiveLargest, std::abs(found.visible * whole - (whole - hidden)));
        }
    EXPECT_GT(naiveLargest, 1e-3) << "the share of area, without cosines and distances, is another one";
}

// On the floor under a ball of radius 1/2 at a height of 1, and one of light at a height of 4. The ball is given to each point as
// the disc that it looks like from there, a corner of which is in the vertical plane through both.
TEST(Eclipse, WhereUmbraAndPenumbraEnd) {
    constexpr int kSides = 4096;
    const auto at = [](double x, double lightRadius) {
        const dvec3 point(x, 0, 0), toOccluder = dvec3(0, 1, 0) - point;
        const double distance = glm::length(toOccluder), sine = 0.5 / distance;
        const Cap cap{toOccluder / distance, std::asin(sine)};
        return behind(discBefore(point, cap, distance * (1 - sine * sine), {1, 0, 0}, kSides),
                      sphereLight({0, 4, 0}, lightRadius), point, {0, 1, 0})
            .visible;
    };
    struct Row {
        double lightRadius, umbra, penumbra;
    };
    constexpr std::array<Row, 5> kTable = {{{.1, .6390391543, .7144345083},
                                            {.25, .585369407, .7745966692},
                                            {.5, .5, .8838834765},
                                            {.6, .4669261422, .9315466731},
                                            {1, .3380617019, 1.154700538}}};
    // What is added up to tell light from shadow is right to rounding; 26 halvings of 1 m are 1.5e-8.
    const auto borderOf = [](double inside, double outside, const auto& isInside) {
        for (int i = 0; i < 26; ++i) {
            const double middle = 0.5 * (inside + outside);
            (isInside(middle) ? inside : outside) = middle;
        }
        return outside;
    };
    // The polygon's sides come (pi / sides)^2 / 2 of the radius too near to its middle, 1.5e-7 m, and floats round 6e-8 m; on the
    // floor that is up to four times as much.
    constexpr double kPolygon = 1e-6;
    for (const Row& row : kTable) {
        const auto isDark = [&](double x) { return at(x, row.lightRadius) < 1e-13; };
        const auto isShaded = [&](double x) { return at(x, row.lightRadius) < 1 - 1e-13; };
        EXPECT_NEAR(borderOf(row.umbra - 0.1, row.umbra + 0.1, isDark), row.umbra, kPolygon) << row.lightRadius;
        EXPECT_NEAR(borderOf(row.penumbra - 0.1, row.penumbra + 0.1, isShaded), row.penumbra, kPolygon)
            << row.lightRadius;
    }
}

} // namespace
} // namespace shadowlab::trace
