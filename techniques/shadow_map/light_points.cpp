// SPDX-License-Identifier: MIT
#include "techniques/shadow_map/light_points.h"

#include <algorithm>
#include <cmath>
#include <random>

#include <glm/gtc/constants.hpp>

namespace shadowlab::shadow_map {

namespace {

/// One point in each of `count` rectangles of equal area that fill the unit square. In rows: as many as columns, or nearly, so
/// that no number of points is refused. Cook, "Stochastic Sampling in Computer Graphics", 1986 (jittering).
std::vector<dvec2> jitteredSquare(int count, const auto& chance) {
    const int rows = std::max(1, static_cast<int>(std::lround(std::sqrt(count))));
    std::vector<dvec2> points;
    for (int row = 0; row < rows; ++row) {
        const int first = row * count / rows, last = (row + 1) * count / rows; // of all points, those in this row
        for (int i = first; i < last; ++i)
            points.emplace_back((i - first + chance()) / (last - first), (first + chance() * (last - first)) / count);
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

} // namespace

std::vector<dvec3> pointsOfLight(const scene::Light& light, int lightNumber, const LightPointParams& params) {
    std::mt19937 numbers(static_cast<std::uint32_t>(params.seed + 1000003 * lightNumber));
    const auto chance = [&numbers] { return static_cast<double>(numbers()) / 4294967296.0; };
    std::vector<dvec3> points;
    const bool jittered = params.spread == LightPointParams::Spread::jittered;
    for (const dvec2& p : jittered ? jitteredSquare(params.count, chance) : randomSquare(params.count, chance)) {
        if (light.type == scene::LightType::rect) {
            points.push_back(light.positionWorld + (p.x - 0.5) * light.edgeUWorld + (p.y - 0.5) * light.edgeVWorld);
            continue;
        }
        // The surface of a sphere in three dimensions, seen along one of them, is a line filled evenly (Archimedes). One more
        // dimension: that of a sphere in four, seen along two, is a disc filled evenly. So take a point there, by its two
        // radii and two angles, and leave one coordinate out.
        constexpr double kTurn = glm::two_pi<double>();
        const double nearRadius = std::sqrt(p.x), farRadius = std::sqrt(1 - p.x);
        const dvec3 unit(nearRadius * std::cos(kTurn * p.y), nearRadius * std::sin(kTurn * p.y),
                         farRadius * std::cos(kTurn * chance()));
        points.push_back(light.positionWorld + light.radius * unit);
    }
    return points;
}

} // namespace shadowlab::shadow_map
