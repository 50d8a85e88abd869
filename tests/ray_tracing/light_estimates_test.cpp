// What is estimated with directions toward a light, held against what is known without them.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <iostream>
#include <random>

#include "techniques/foundation/trace/area/area_visibility.h"
#include "techniques/foundation/trace/bvh/bvh_traverse.h"
#include "techniques/ray_tracing/sampling/light_sampling.h"
#include "tests/support/area_lights.h"
#include "tests/support/hard_scenes.h"
#include "tests/support/perforated.h"
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
    int samples = 1000000; ///< of each estimate
    double alike = 1e-9;   ///< share of the whole that the exact number may be wrong by
    int compared = 0, partly = 0;
    double largest = 0, sum = 0;
};

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
        EXPECT_NEAR(exact.visible, area.share(point), comparisons.alike);
        const auto goesOn = [&](std::uint32_t primitive, const dvec3& barycentric) {
            return tracer.mayHaveHoles(primitive) && tracer.isInHole({primitive, false, dvec2(barycentric)});
        };
        double sum = 0, squares = 0, weights = 0, weighted = 0;
        for (int n = 0; n < comparisons.samples; ++n) {
            const LightSample sample = sampler.sample({chance(numbers), chance(numbers)});
            weights += sample.areaWeight;
            const trace::Ray ray{from, sample.onLightCentredOffset, trace::kContact, 1 - trace::kContact};
            if (!(glm::dot(up, sample.towardWorld) > 0)) continue;
            if (tracer.bvh().any(ray, casts, goesOn) != trace::kNoPrimitive) continue;
            const double value = sample.solidAngle * std::max(0.0, glm::dot(normal, sample.towardWorld)) / M_PI;
            sum += value, squares += value * value;
            weighted += sample.areaWeight;
        }
        const double count = comparisons.samples;
        const double mean = sum / count, sigma = std::sqrt(std::max(squares / count - mean * mean, 0.0) / count);
        // What does not vary has no sigma: then the roundings of the sum are all there is.
        const double z = (mean - exact.irradiance) / std::hypot(sigma, comparisons.alike * exact.unshadowed);
        comparisons.largest = std::max(comparisons.largest, std::abs(z));
        comparisons.sum += z;
        ++comparisons.compared;
        // Half of a light, seen by so many rays, five standard deviations; and what the exact number may be wrong by.
        EXPECT_NEAR(weighted / weights, exact.visible, 5 * (0.5 / std::sqrt(count) + comparisons.alike));
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

// Behind holes pieces are asked with 1024 rays for the whole light, which is wrong by at most 1/64, one standard deviation.
TEST(LightEstimates, RaysFindTheIrradianceThroughHoles) {
    Comparisons comparisons{.samples = 40000, .alike = 1.0 / 64};
    for (const scene::Light& light : {rectLight({1, 5, 2.5}, {1, 0, 0}, {0, 0, 1}), sphereLight({1, 5, 2.5}, 0.6)}) {
        scene::Scene scene = testing::perforatedScene();
        scene.lights = {light};
        compare(testing::snapshot(std::move(scene)), 8, 3, comparisons);
    }
    std::cout << comparisons.partly << " partly seen, at most " << comparisons.largest << " sigma\n";
    EXPECT_EQ(comparisons.compared, 16);
    EXPECT_GT(comparisons.partly, 8);
    EXPECT_LT(comparisons.largest, 4.5);
}

} // namespace
} // namespace shadowlab::ray_tracing
