// What is estimated with directions toward a light, held against what is known without them.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <iostream>
#include <random>

#include "techniques/foundation/trace/area_visibility.h"
#include "techniques/foundation/trace/bvh_traverse.h"
#include "techniques/ray_tracing/light_sampling.h"
#include "tests/support/area_lights.h"
#include "tests/support/hard_scenes.h"
#include "tests/support/scenes.h"

namespace shadowlab::ray_tracing {
namespace {

using testing::rectLight, testing::sphereLight, testing::tracerOf;
using trace::SurfacePoint;

// Solid angles of what two caps of directions have in common: r1, r2, and the angle between their axes. Row by row of equal
// random01.x, a circle around the light's axis, the part of which that is within the other cap is known by its angle. Between
// the rows at which the circle begins and ends to be cut, it is integrated to the fourth power of their distance.
TEST(LightEstimates, WhatTwoCapsHaveInCommon) {
    struct Row {
        double light, other, between, solidAngle;
    };
    constexpr std::array<Row, 4> kTable = {{{.2, .15, .1, .05893692621},
                                            {.2, .15, .2, .02965347795},
                                            {.2, .3, .25, .07325399513},
                                            {.3, .3, .3, .1106034891}}};
    constexpr int kRows = 400;
    for (const Row& row : kTable) {
        const LightSampler sampler(sphereLight({0, 4, 0}, 4 * std::sin(row.light)), dvec3(0));
        const dvec3 axis(0, 1, 0);
        // In the vertical plane of the first column, so that what is cut out of a circle begins there on either side.
        const dvec3 first = sampler.sample({1, 0}).towardWorld;
        const dvec3 aside = glm::normalize(first - glm::dot(first, axis) * axis);
        const dvec3 other = std::cos(row.between) * axis + std::sin(row.between) * aside;
        const auto isWithin = [&](dvec2 at) {
            return glm::dot(sampler.sample(at).towardWorld, other) > std::cos(row.other);
        };
        const auto partWithin = [&](double x) {
            if (isWithin({x, 0.5})) return 1.0; // also where it is farthest away
            if (!isWithin({x, 0})) return 0.0;
            double inside = 0, outside = 0.5;
            for (int i = 0; i < 50; ++i) {
                const double middle = 0.5 * (inside + outside);
                (isWithin({x, middle}) ? inside : outside) = middle;
            }
            return 2 * inside;
        };
        const auto rowOf = [&](double angle) {
            return std::pow(std::sin(0.5 * std::min(angle, row.light)) / std::sin(0.5 * row.light), 2);
        };
        const std::array<double, 4> ends = {0, rowOf(std::abs(row.between - row.other)), rowOf(row.between + row.other),
                                            1};
        double share = 0;
        for (int part = 0; part < 3; ++part)
            for (int i = 0; i < kRows; ++i) {
                const double t = (i + 0.5) / kRows, width = ends[part + 1] - ends[part];
                share += width * 30 * t * t * (1 - t) * (1 - t) / kRows *
                         partWithin(ends[part] + width * t * t * t * (10 - 15 * t + 6 * t * t));
            }
        EXPECT_NEAR(share * sampler.solidAngle(), row.solidAngle, 1e-9) << row.between; // the table has ten digits
    }
}

/// Comparisons of an exact number with an estimate, each in standard deviations of the estimate.
struct Comparisons {
    int compared = 0, partly = 0;
    double largest = 0, sum = 0;
};

constexpr int kSamples = 1000000;

/// Points of all surfaces that a camera sees, most of them in penumbras, with shading normals that lean up to half a radian.
void compare(const scene::Snapshot& snapshot, int wanted, unsigned seed, Comparisons& comparisons) {
    const trace::SceneTracer tracer = tracerOf(snapshot);
    const trace::AreaVisibility area(tracer, 0);
    const scene::Light& light = snapshot->lights[0];
    const trace::EyeRays rays = tracer.eyeRays(snapshot->camera, ivec2(1000));
    std::mt19937_64 numbers(seed);
    std::uniform_real_distribution<double> pixel(0, 1000), chance(0, 1), tilt(-0.3, 0.3);
    int taken = 0;
    for (int i = 0; i < 1000 * wanted && taken < wanted; ++i) {
        const SurfacePoint point = tracer.eyePoint(rays, {pixel(numbers), pixel(numbers)});
        if (!point || !tracer.facesLight(point, 0)) continue;
        const trace::Triangle& own = tracer.bvh().triangles[point.primitive];
        const dvec3 up = (point.eyeOnFront ? 1.0 : -1.0) * glm::normalize(glm::cross(own.b - own.a, own.c - own.a));
        const dvec3 normal = glm::normalize(up + dvec3(tilt(numbers), tilt(numbers), tilt(numbers)));
        trace::AreaIrradiance exact;
        area.irradiances({&point, 1}, {&normal, 1}, {&exact, 1});
        const bool isPartly = exact.irradiance > 0 && exact.irradiance < 0.999 * exact.unshadowed;
        if (!isPartly && i % 16 != 0) continue;
        ++taken;
        comparisons.partly += isPartly ? 1 : 0;
        const dvec3 from = tracer.positionCentred(point);
        const LightSampler sampler(light, tracer.positionWorld(point));
        const auto casts = [&](std::uint32_t primitive) {
            return primitive != point.primitive && snapshot->objects[tracer.world().objects[primitive]].castsShadow;
        };
        double sum = 0, squares = 0, weights = 0, weighted = 0;
        for (int n = 0; n < kSamples; ++n) {
            const LightSample sample = sampler.sample({chance(numbers), chance(numbers)});
            weights += sample.areaWeight;
            const trace::Ray ray{from, sample.onLightCentredOffset, trace::kContact, 1 - trace::kContact};
            if (!(glm::dot(up, sample.towardWorld) > 0)) continue;
            if (tracer.bvh().any(ray, casts) != trace::kNoPrimitive) continue;
            const double value = sample.solidAngle * std::max(0.0, glm::dot(normal, sample.towardWorld)) / M_PI;
            sum += value, squares += value * value;
            weighted += sample.areaWeight;
        }
        const double mean = sum / kSamples, sigma = std::sqrt((squares / kSamples - mean * mean) / kSamples);
        // What does not vary has no sigma: then the million roundings of the sum are all there is.
        const double z = (mean - exact.irradiance) / std::max(sigma, 1e-9 * exact.unshadowed);
        comparisons.largest = std::max(comparisons.largest, std::abs(z));
        comparisons.sum += z;
        ++comparisons.compared;
        // Half a light seen by a million rays is right to 5e-4; five times that.
        EXPECT_NEAR(weighted / weights, exact.visible, 2.5e-3);
    }
}

TEST(LightEstimates, AMillionRaysFindTheIrradiance) {
    Comparisons comparisons;
    for (const bool sphere : {false, true}) {
        compare(testing::snapshot([&] {
                    scene::Scene scene = testing::simpleScene();
                    scene.lights = {sphere ? sphereLight({2, 4, 2.5}, 0.6)
                                           : rectLight({2, 4, 2.5}, {1, 0, -1}, {-0.5, -1.2, -0.5})};
                    return scene;
                }()),
                2, 1, comparisons);
        // A skewed rect, a ball, among triangles in every direction.
        compare(testing::snapshot([&] {
                    scene::Scene scene = testing::hardScene(testing::HardClass::soup, 3, false);
                    const dvec3 centre = scene.lights[0].positionWorld;
                    scene.lights = {sphere ? sphereLight(centre, 0.3)
                                           : rectLight(centre, {0.9, 0.1, 0.2}, {-0.2, 0.1, 0.7})};
                    return scene;
                }()),
                4, 2, comparisons);
    }
    std::cout << comparisons.compared << " points, " << comparisons.partly << " partly seen, at most "
              << comparisons.largest << " sigma, mean " << comparisons.sum / comparisons.compared << '\n';
    EXPECT_EQ(comparisons.compared, 12);
    EXPECT_GT(comparisons.partly, 6);
    // Bonferroni: of 12 normal answers one is beyond 4.5 sigma once in twelve thousand times. Their mean has sigma 1 / sqrt(12).
    EXPECT_LT(comparisons.largest, 4.5);
    EXPECT_LT(std::abs(comparisons.sum / comparisons.compared), 4 / std::sqrt(comparisons.compared));
}

} // namespace
} // namespace shadowlab::ray_tracing
