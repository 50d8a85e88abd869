// SPDX-License-Identifier: MIT
#include "techniques/foundation/scene/query/light_points.h"

#include <algorithm>
#include <cmath>
#include <random>
#include <utility>

#include <glm/gtc/constants.hpp>

namespace shadowlab::scene {

namespace {

/// One point in each of `count` rectangles of equal area that fill the unit square. In rows, about as many as columns, so
/// that any number of points is possible. Cook, "Stochastic Sampling in Computer Graphics", 1986 (jittering).
std::vector<dvec2> jitteredSquare(int count, const auto& chance) {
    const int rows = std::max(1, static_cast<int>(std::lround(std::sqrt(count))));
    std::vector<dvec2> points;
    for (int row = 0; row < rows; ++row) {
        const int first = row * count / rows, last = (row + 1) * count / rows; // of all points, those in this row
        for (int i = first; i < last; ++i) {
            const double across = chance(), along = chance(); // in this order with every compiler
            points.emplace_back((i - first + across) / (last - first), (first + along * (last - first)) / count);
        }
    }
    return points;
}

std::vector<dvec2> randomSquare(int count, const auto& chance) {
    std::vector<dvec2> points(static_cast<std::size_t>(count));
    for (dvec2& point : points) {
        point.x = chance();
        point.y = chance();
    }
    return points;
}

/// Points spread evenly over the unit cube (a low-discrepancy sequence), shifted together by a random vector: multiples of
/// the powers of a number that is badly approximated by fractions. Roberts, "The Unreasonable Effectiveness of Quasirandom
/// Sequences", 2018.
std::vector<dvec3> evenCube(int count, const auto& chance) {
    constexpr double kRoot = 1.2207440846057594754; // of x^4 = x + 1
    dvec3 shift;
    for (int axis = 0; axis < 3; ++axis)
        shift[axis] = chance();
    std::vector<dvec3> points;
    for (int i = 0; i < count; ++i)
        points.push_back(glm::fract(shift + static_cast<double>(i) *
                                                dvec3(1 / kRoot, 1 / (kRoot * kRoot), 1 / (kRoot * kRoot * kRoot))));
    return points;
}

std::vector<dvec3> randomCube(int count, const auto& chance) {
    std::vector<dvec3> points(static_cast<std::size_t>(count));
    for (dvec3& point : points)
        for (int axis = 0; axis < 3; ++axis)
            point[axis] = chance();
    return points;
}

} // namespace

std::vector<dvec3> pointsOfLight(const Light& light, int lightNumber, const LightPointParams& params) {
    std::mt19937 numbers(static_cast<std::uint32_t>(params.seed + 1000003 * lightNumber));
    const auto chance = [&numbers] { return static_cast<double>(numbers()) / 4294967296.0; };
    std::vector<dvec3> points;
    const bool jittered = params.spread == LightPointParams::Spread::jittered;
    if (light.type == LightType::rect) {
        for (const dvec2& p : jittered ? jitteredSquare(params.count, chance) : randomSquare(params.count, chance))
            points.push_back(light.positionWorld + (p.x - 0.5) * light.edgeUWorld + (p.y - 0.5) * light.edgeVWorld);
        return points;
    }
    for (const dvec3& p : jittered ? evenCube(params.count, chance) : randomCube(params.count, chance)) {
        // Archimedes: points spread evenly on the sphere in three dimensions, projected onto one axis, fill an interval
        // evenly. In the same way points on the sphere in four dimensions, projected onto two, fill a disc evenly. So a
        // point is chosen there, by two radii and two angles, and one coordinate is dropped.
        const double nearRadius = std::sqrt(p.x), farRadius = std::sqrt(1 - p.x);
        const dvec3 angles = glm::two_pi<double>() * p;
        const dvec3 unit(nearRadius * std::cos(angles.y), nearRadius * std::sin(angles.y),
                         farRadius * std::cos(angles.z));
        points.push_back(light.positionWorld + light.radius * unit);
    }
    return points;
}

params::ParamList describe(LightPointParams& points, std::string unit, std::string help) {
    using params::onlyIf, params::integer, params::choice;
    const auto areMany = [&points] { return points.count > 1; };
    return params::inGroup(
        kAreaLights,
        {
            integer({"light-samples", "Samples of an area light"}, points.count, 1, 1024, std::move(unit),
                    std::move(help)),
            onlyIf(areMany, choice({"light-points", "Sample pattern"}, points.spread, {"jittered", "random"},
                                   "Sample points on the light: one at random in each of as many equal parts; or all "
                                   "at random, which needs far more of them (teaching).")),
            onlyIf(areMany, integer({"light-seed", "Random seed"}, points.seed, 0, 1000000, "",
                                    "Start of the random numbers: another seed, other sample points.")),
        });
}

} // namespace shadowlab::scene
