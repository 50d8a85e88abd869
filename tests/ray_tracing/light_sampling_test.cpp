// Directions toward lights by solid angle: that they are evenly spread, and that what is estimated with them is right.
// SPDX-License-Identifier: MIT
#include "techniques/ray_tracing/sampling/light_sampling.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <iostream>
#include <random>
#include <vector>

#include "tests/support/area_lights.h"

namespace shadowlab::ray_tracing {
namespace {

using testing::rectLight, testing::sphereLight;

// A million places in the middles of a grid. Where what is added up jumps, the mean is right to a cell's width.
constexpr int kSide = 1000;

template <typename Value>
double meanOverGrid(const Value& value) {
    double sum = 0;
    for (int row = 0; row < kSide; ++row)
        for (int column = 0; column < kSide; ++column)
            sum += value(dvec2(column + 0.5, row + 0.5) / double(kSide));
    return sum / kSide / kSide;
}

// A grid of which the cells get narrower toward the border, and count less, as t^3 (10 - 15 t + 6 t^2) says: where a light
// reaches the horizon, its cosine begins like a root there, which would cost equal cells half of the digits. What does not jump is then
// integrated to the fourth power of a cell's width, 4e-11 for 400, times what it bends.
constexpr int kFineSide = 400;
constexpr double kGrid = 1e-6;

template <typename Value>
double smoothMean(const Value& value) {
    const auto place = [](double t) { return t * t * t * (10 - 15 * t + 6 * t * t); };
    const auto weight = [](double t) { return 30 * t * t * (1 - t) * (1 - t); };
    double sum = 0;
    for (int row = 0; row < kFineSide; ++row)
        for (int column = 0; column < kFineSide; ++column) {
            const double x = (column + 0.5) / kFineSide, y = (row + 0.5) / kFineSide;
            sum += weight(x) * weight(y) * value(dvec2(place(x), place(y)));
        }
    return sum / kFineSide / kFineSide;
}

std::array<dvec3, 4> cornersFrom(const scene::Light& light, const dvec3& pointWorld) {
    const dvec3 toCentre = light.positionWorld - pointWorld;
    const dvec3 u = 0.5 * light.edgeUWorld, v = 0.5 * light.edgeVWorld;
    return {toCentre - u - v, toCentre - u + v, toCentre + u + v, toCentre + u - v};
}

/// J. H. Lambert, 1760: the integral of the cosine over a polygon that lies above the horizon.
double lambert(const std::array<dvec3, 4>& corners, const dvec3& normal) {
    double sum = 0;
    for (std::size_t i = 0; i < 4; ++i) {
        const dvec3 &a = corners[i], &b = corners[(i + 1) % 4], side = glm::cross(a, b);
        sum += std::atan2(glm::length(side), glm::dot(a, b)) * glm::dot(normal, side) / glm::length(side);
    }
    return std::abs(0.5 * sum);
}

/// A. Girard: what the angles at a quadrilateral's corners are more than 2 pi.
double girard(const std::array<dvec3, 4>& corners) {
    double sum = -2 * M_PI;
    for (std::size_t i = 0; i < 4; ++i) {
        const dvec3 &before = corners[(i + 3) % 4], &here = corners[i], &after = corners[(i + 1) % 4];
        const dvec3 m = glm::cross(here, before), n = glm::cross(here, after);
        sum += std::atan2(glm::length(glm::cross(m, n)), glm::dot(m, n));
    }
    return sum;
}

struct RectCase {
    scene::Light light;
    dvec3 pointWorld;
};

/// From the front of each light; above the horizon of (0, 1, 0) all of it.
std::vector<RectCase> rectCases() {
    return {
        {rectLight({0, 4, 0}, {1, 0, 0}, {0, 0, 1}), {0.25, 0, 0.5}},
        {rectLight({0, 4, 0}, {1, 0, 0}, {0, 0, 1}), {7, 0, -3}},
        {rectLight({0, 1, 0}, {20, 0, 0}, {0, 0, 20}), {1, 0, 2}},            // nearly all of the hemisphere
        {rectLight({0, 4, 0}, {1e-3, 0, 0}, {0, 0, 2e-3}), {0.5, 0, 0}},      // 1e-7 steradian
        {rectLight({0, 1, 0}, {0, 0, 3}, {0, -2, 0}), {1e-3, 0, 0.25}},       // a panel that stands on the floor
        {rectLight({0, 4, 0}, {1, 0, 0}, {0.75, 0, 1}), {0.5, 0, -0.5}},      // skewed
        {rectLight({0, 2, 0}, {1, 0.5, 0.25}, {2, 0.25, 2}), {-1, 0.5, 0.5}}, // skewed and tilted
        {rectLight({0, 1, 0}, {6, 0, 0}, {8, 0, 1}), {1, 0, -1}},             // nearly a stripe
    };
}

TEST(LightSampling, MeanOverARectIsLambertsFormula) {
    const dvec3 up(0, 1, 0);
    for (const RectCase& rect : rectCases()) {
        const LightSampler sampler(rect.light, rect.pointWorld);
        const auto corners = cornersFrom(rect.light, rect.pointWorld);
        ASSERT_GT(sampler.solidAngle(), 0);
        EXPECT_NEAR(sampler.solidAngle(), girard(corners), 1e-12); // angles of a few radians, in double
        const double mean =
            smoothMean([&](dvec2 at) { return sampler.solidAngle() * glm::dot(up, sampler.sample(at).towardWorld); });
        EXPECT_NEAR(mean, lambert(corners, up), kGrid) << rect.pointWorld.x;
    }
}

TEST(LightSampling, MeanOverASphereIsPiSineSquared) {
    const dvec3 normal = glm::normalize(dvec3(0.25, 1, 0.5));
    for (const double distance : {0.501, 0.6, 1.0, 4.0, 1e3}) {
        // Straight above, where at 60 degrees all of it is above the horizon.
        for (const double tilt : {0.0, M_PI / 3}) {
            if (tilt > 0 && distance < 4) continue;
            const dvec3 aside = glm::normalize(glm::cross(normal, dvec3(1, 0, 0)));
            const dvec3 way = std::cos(tilt) * normal + std::sin(tilt) * aside, point(3, -1, 2);
            const LightSampler sampler(sphereLight(point + distance * way, 0.5), point);
            const double sine = 0.5 / distance;
            const double mean = smoothMean(
                [&](dvec2 at) { return sampler.solidAngle() * glm::dot(normal, sampler.sample(at).towardWorld); });
            EXPECT_NEAR(mean / (sine * sine), M_PI * std::cos(tilt), kGrid) << distance;
        }
    }
}

TEST(LightSampling, DirectionsLandOnTheLight) {
    std::mt19937_64 numbers(1);
    std::uniform_real_distribution<double> chance(0, 1);
    for (const RectCase& rect : rectCases())
        for (int i = 0; i < 2000; ++i) {
            const LightSample sample = sampleLight(rect.light, rect.pointWorld, {chance(numbers), chance(numbers)});
            ASSERT_NEAR(glm::length(sample.towardWorld), 1, 1e-14);
            ASSERT_NEAR(glm::dot(sample.towardWorld, sample.onLightCentredOffset),
                        glm::length(sample.onLightCentredOffset), 1e-13);
            const dvec3 &u = rect.light.edgeUWorld, &v = rect.light.edgeVWorld, normal = glm::cross(u, v);
            const dvec3 place = rect.pointWorld + sample.onLightCentredOffset - rect.light.positionWorld;
            // Shares of the edges; the nearly parallel ones lose a digit.
            const double area = glm::dot(normal, normal);
            ASSERT_LE(std::abs(glm::dot(normal, glm::cross(place, v)) / area), 0.5 + 1e-11);
            ASSERT_LE(std::abs(glm::dot(normal, glm::cross(u, place)) / area), 0.5 + 1e-11);
            ASSERT_NEAR(glm::dot(normal, place) / area, 0, 1e-8);
        }
    for (const double distance : {0.5000001, 0.6, 4.0, 1e4})
        for (int i = 0; i < 2000; ++i) {
            const dvec3 toCentre(0, distance, 0);
            const LightSample sample =
                sampleLight(sphereLight(toCentre, 0.5), dvec3(0), {chance(numbers), chance(numbers)});
            ASSERT_NEAR(glm::length(sample.onLightCentredOffset - toCentre), 0.5, 1e-14 * distance + 1e-12);
            ASSERT_LE(glm::length(sample.onLightCentredOffset), distance) << "the near side of it";
        }
}

/// Of counts in cells that should hold so many: (chi-square - cells) / its standard deviation, which is about normal.
double chiSquareSigmas(const std::vector<double>& counts, const std::vector<double>& expected) {
    double sum = 0;
    for (std::size_t i = 0; i < counts.size(); ++i)
        sum += (counts[i] - expected[i]) * (counts[i] - expected[i]) / expected[i];
    const auto freedom = static_cast<double>(counts.size() - 1);
    return (sum - freedom) / std::sqrt(2 * freedom);
}

// Five standard deviations: with less than a hundred answers a false alarm comes once in ten thousand seeds, and the seed is
// fixed.
constexpr double kSigmas = 5;
constexpr int kSamples = 200000, kCells = 8;

/// How evenly are the offsets spread over the solid angle of a rect, in cells of equal parts of its edges?
template <typename Offset>
double rectSigmas(const RectCase& rect, const Offset& offset) {
    const dvec3 &u = rect.light.edgeUWorld, &v = rect.light.edgeVWorld, normal = glm::cross(u, v);
    std::vector<double> counts(kCells * kCells), expected(kCells * kCells);
    std::mt19937_64 numbers(2);
    std::uniform_real_distribution<double> chance(0, 1);
    const auto cell = [](double share) { return std::clamp(static_cast<int>(share * kCells), 0, kCells - 1); };
    for (int i = 0; i < kSamples; ++i) {
        const dvec3 place =
            offset(dvec2(chance(numbers), chance(numbers))) + rect.pointWorld - rect.light.positionWorld;
        const int column = cell(0.5 + glm::dot(normal, glm::cross(place, v)) / glm::dot(normal, normal));
        const int row = cell(0.5 + glm::dot(normal, glm::cross(u, place)) / glm::dot(normal, normal));
        ++counts[static_cast<std::size_t>(row * kCells + column)];
    }
    const double whole = girard(cornersFrom(rect.light, rect.pointWorld));
    for (int row = 0; row < kCells; ++row)
        for (int column = 0; column < kCells; ++column) {
            const dvec3 centre =
                rect.light.positionWorld + ((column + 0.5) / kCells - 0.5) * u + ((row + 0.5) / kCells - 0.5) * v;
            const scene::Light part = rectLight(centre, u / double(kCells), v / double(kCells));
            expected[static_cast<std::size_t>(row * kCells + column)] =
                kSamples * girard(cornersFrom(part, rect.pointWorld)) / whole;
        }
    return chiSquareSigmas(counts, expected);
}

TEST(LightSampling, RectsAreSpreadEvenlyOverTheSolidAngle) {
    double naiveMost = 0;
    for (const RectCase& rect : rectCases()) {
        const LightSampler sampler(rect.light, rect.pointWorld);
        if (sampler.solidAngle() < 1e-3) continue; // Girard's sum has no digits left for its cells
        EXPECT_LT(std::abs(rectSigmas(rect, [&](dvec2 at) { return sampler.sample(at).onLightCentredOffset; })),
                  kSigmas)
            << rect.pointWorld.x;
        const double naive = rectSigmas(rect, [&](dvec2 at) {
            return rect.light.positionWorld - rect.pointWorld + (at.x - 0.5) * rect.light.edgeUWorld +
                   (at.y - 0.5) * rect.light.edgeVWorld;
        });
        naiveMost = std::max(naiveMost, naive);
    }
    EXPECT_GT(naiveMost, 1000) << "places chosen by area are not";
}

TEST(LightSampling, SpheresAreSpreadEvenlyOverTheSolidAngle) {
    for (const double distance : {0.51, 1.0, 30.0}) {
        const dvec3 toCentre = distance * glm::normalize(dvec3(1, 2, -0.5));
        const LightSampler sampler(sphereLight(toCentre, 0.5), dvec3(0));
        const dvec3 axis = glm::normalize(toCentre), aside = glm::normalize(glm::cross(axis, dvec3(0, 0, 1)));
        const dvec3 beside = glm::cross(axis, aside);
        const double widest = std::asin(0.5 / distance);
        std::vector<double> counts(kCells * kCells);
        std::mt19937_64 numbers(3);
        std::uniform_real_distribution<double> chance(0, 1);
        for (int i = 0; i < kSamples; ++i) {
            const dvec3 w = sampler.sample({chance(numbers), chance(numbers)}).towardWorld;
            // Zones of equal solid angle are equally high (Archimedes); heights by half angles, to keep the digits.
            const double half = std::asin(0.5 * glm::length(w - axis));
            const double zone = std::pow(std::sin(half) / std::sin(0.5 * widest), 2);
            const double turn = std::atan2(glm::dot(w, beside), glm::dot(w, aside)) / (2 * M_PI) + 0.5;
            const auto cell = [](double share) { return std::clamp(static_cast<int>(share * kCells), 0, kCells - 1); };
            ++counts[static_cast<std::size_t>(cell(zone) * kCells + cell(turn))];
        }
        const std::vector<double> expected(counts.size(), double(kSamples) / static_cast<double>(counts.size()));
        EXPECT_LT(std::abs(chiSquareSigmas(counts, expected)), kSigmas) << distance;
    }
}

// A panel that stands on the floor, seen from the floor as near as 1e-6 m before it. What is estimated lies between 0 and
// pi (a quarter of all directions), so its variance is at most (pi / 2)^2, and that of a mean of N at most pi^2 / 4N. By area it
// is 1 / d^2 that is added up.
TEST(LightSampling, ALightThatTouchesTheFloor) {
    const scene::Light panel = rectLight({0, 1, 0}, {0, 0, 3}, {0, -2, 0});
    const dvec3 up(0, 1, 0), panelNormal(1, 0, 0);
    double naiveLargest = 0;
    for (const double distance : {1.0, 0.1, 1e-2, 1e-3, 1e-6}) {
        const dvec3 point(distance, 0, 0.25);
        const LightSampler sampler(panel, point);
        std::mt19937_64 numbers(4);
        std::uniform_real_distribution<double> chance(0, 1);
        double sum = 0, squares = 0, naiveSum = 0, naiveSquares = 0;
        for (int i = 0; i < kSamples; ++i) {
            const dvec2 at(chance(numbers), chance(numbers));
            const double value = sampler.solidAngle() * std::max(0.0, glm::dot(up, sampler.sample(at).towardWorld));
            ASSERT_LE(value, M_PI);
            sum += value, squares += value * value;
            const dvec3 way =
                panel.positionWorld - point + (at.x - 0.5) * panel.edgeUWorld + (at.y - 0.5) * panel.edgeVWorld;
            const double squared = glm::dot(way, way);
            const double naive = 6 * std::max(0.0, way.y) * -glm::dot(panelNormal, way) / (squared * squared);
            naiveSum += naive, naiveSquares += naive * naive;
        }
        const double mean = sum / kSamples, variance = squares / kSamples - mean * mean;
        EXPECT_LE(variance, M_PI * M_PI / 4) << distance;
        // No bias: Lambert's formula holds for a polygon that ends in the horizon, too.
        EXPECT_LT(std::abs(mean - lambert(cornersFrom(panel, point), up)), kSigmas * std::sqrt(variance / kSamples))
            << distance;
        const double naiveMean = naiveSum / kSamples;
        naiveLargest = std::max(naiveLargest, naiveSquares / kSamples - naiveMean * naiveMean);
        std::cout << distance << " m: variance " << variance << ", by area "
                  << naiveSquares / kSamples - naiveMean * naiveMean << '\n';
    }
    EXPECT_GT(naiveLargest, 10 * M_PI * M_PI / 4) << "places chosen by area make bright dots";
}

// The half plane of area_visibility_test.cpp: from (x, 0, 0) what lies at places beyond -x is seen, 1/2 + x of the area. The
// estimate jumps there, so the grid is right only to a cell's width, 1/side of it.
TEST(LightSampling, TheShareOfARectsArea) {
    const scene::Light panel = rectLight({0, 4, 0}, {1, 0, 0}, {0, 0, 1});
    double naiveMost = 0;
    for (const double x : {-0.375, -0.125, 0.25}) {
        const LightSampler sampler(panel, {x, 0, 0});
        EXPECT_NEAR(smoothMean([&](dvec2 at) { return sampler.sample(at).areaWeight; }), 1, kGrid);
        double seen = 0;
        const double share = meanOverGrid([&](dvec2 at) {
            const LightSample sample = sampler.sample(at);
            const bool isSeen = x + sample.onLightCentredOffset.x > -x;
            seen += isSeen ? 1.0 / kSide / kSide : 0;
            return isSeen ? sample.areaWeight : 0;
        });
        EXPECT_NEAR(share, 0.5 + x, 1.0 / kSide) << x;
        naiveMost = std::max(naiveMost, std::abs(seen - 0.5 - x));
    }
    EXPECT_GT(naiveMost, 3.0 / kSide) << "the share of directions is another one";
}

// A plane through the point cuts a segment off the disc that the point sees of a sphere; its distance from the disc's middle, in
// radii, is k. From near by the disc is far from what the directions alone would tell.
TEST(LightSampling, TheShareOfASpheresDisc) {
    double naiveMost = 0;
    for (const double distance : {0.6, 1.0, 4.0})
        for (const double k : {-0.75, -0.25, 0.0, 0.5}) {
            const double sine = 0.5 / distance, tangent = sine / std::sqrt(1 - sine * sine);
            const LightSampler sampler(sphereLight({0, distance, 0}, 0.5), dvec3(0));
            EXPECT_NEAR(smoothMean([&](dvec2 at) { return sampler.sample(at).areaWeight; }), 1, kGrid) << distance;
            double seen = 0;
            const double share = meanOverGrid([&](dvec2 at) {
                const LightSample sample = sampler.sample(at);
                const dvec3 way = sample.towardWorld;
                const bool isSeen = way.x / way.y > k * tangent;
                seen += isSeen ? 1.0 / kSide / kSide : 0;
                return isSeen ? sample.areaWeight : 0;
            });
            // A grid of kSide cells in either direction is cut along a curve.
            EXPECT_NEAR(share, (std::acos(k) - k * std::sqrt(1 - k * k)) / M_PI, 1.0 / kSide) << distance << ' ' << k;
            naiveMost = std::max(naiveMost, std::abs(seen - share));
        }
    EXPECT_GT(naiveMost, 10.0 / kSide) << "the share of directions is another one";
}

TEST(LightSampling, NothingIsSeenFromBehindWithinAndInThePlane) {
    const scene::Light panel = rectLight({0, 4, 0}, {1, 0, 0}, {0, 0, 1}), ball = sphereLight({0, 4, 0}, 0.5);
    for (const dvec3& point : {dvec3(0, 5, 0), dvec3(0, 4, 0), dvec3(3, 4, 1), dvec3(0.25, 4, 0.25)})
        EXPECT_EQ(sampleLight(panel, point, {0.25, 0.75}).solidAngle, 0) << point.x;
    for (const dvec3& point : {dvec3(0, 4, 0), dvec3(0.25, 4, 0.25), dvec3(0, 4.5, 0)})
        EXPECT_EQ(sampleLight(ball, point, {0.25, 0.75}).solidAngle, 0) << point.x;
    EXPECT_EQ(sampleLight(scene::Light(), dvec3(0, -1, 0), {0.5, 0.5}).solidAngle, 0) << "a light without an area";
    // Just before its middle a panel is half of all directions.
    EXPECT_NEAR(sampleLight(panel, {0, 4 - 1e-9, 0}, {0.5, 0.5}).solidAngle, 2 * M_PI, 1e-6);
}

TEST(LightSampling, LightsOfAllSizesAtAllDistances) {
    std::mt19937_64 numbers(5);
    std::uniform_real_distribution<double> power(-6, 6), part(-1, 1), chance(0, 1);
    const auto direction = [&] { return glm::normalize(dvec3(part(numbers), part(numbers), part(numbers))); };
    int seen = 0;
    for (int i = 0; i < 200000; ++i) {
        const double distance = std::pow(10, power(numbers));
        const scene::Light light = i % 2 ? sphereLight(distance * direction(), std::pow(10, power(numbers)))
                                         : rectLight(distance * direction(), std::pow(10, power(numbers)) * direction(),
                                                     std::pow(10, power(numbers)) * direction());
        // The corners of the unit square, too.
        const auto number = [&] { return i % 5 == 0 ? double(chance(numbers) < 0.5) : chance(numbers); };
        const LightSample sample = sampleLight(light, dvec3(0), {number(), number()});
        if (!(sample.solidAngle > 0)) continue;
        ++seen;
        ASSERT_LE(sample.solidAngle, 2 * M_PI + 1e-9) << i;
        ASSERT_NEAR(glm::length(sample.towardWorld), 1, 1e-12) << i;
        ASSERT_TRUE(std::isfinite(glm::length(sample.onLightCentredOffset))) << i;
        ASSERT_TRUE(std::isfinite(sample.areaWeight) && sample.areaWeight > 0) << i;
        ASSERT_NEAR(glm::dot(sample.towardWorld, sample.onLightCentredOffset), glm::length(sample.onLightCentredOffset),
                    1e-9 * glm::length(sample.onLightCentredOffset));
    }
    EXPECT_GT(seen, 70000);
}

} // namespace
} // namespace shadowlab::ray_tracing
