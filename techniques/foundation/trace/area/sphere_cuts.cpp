// SPDX-License-Identifier: MIT
#include "techniques/foundation/trace/area/sphere_cuts.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <glm/gtc/constants.hpp>

#include "techniques/foundation/math/perpendicular.h"
#include "techniques/foundation/trace/area/shaft.h"

namespace shadowlab::trace {

namespace {

constexpr double kChordsOfCircle = 32;

/// The circle in which a plane cuts a sphere: middle + radius * (cos * u + sin * v).
struct Circle {
    dvec3 middle, u, v;
    double radius;
    [[nodiscard]] dvec3 place(double angle, double stretch = 1) const {
        return middle + stretch * radius * (std::cos(angle) * u + std::sin(angle) * v);
    }
};

/// One side of the triangle: a place is within where the product with the normal is not smaller than the level.
struct Side {
    dvec3 normal; ///< unit, in the triangle's plane
    double level;
};

std::array<Side, 3> sidesOf(const Triangle& t, const dvec3& front) {
    std::array<Side, 3> sides;
    const std::array<dvec3, 3> corners = {t.a, t.b, t.c};
    for (std::size_t i = 0; i < 3; ++i) {
        const dvec3 normal = glm::normalize(glm::cross(front, corners[(i + 1) % 3] - corners[i]));
        sides[i] = {normal, glm::dot(normal, corners[i])};
    }
    return sides;
}

/// The angles at which the circle enters or leaves the triangle, and perhaps others; in order, over one turn.
std::vector<double> anglesAtSides(const Circle& circle, const std::array<Side, 3>& sides) {
    std::vector<double> angles;
    for (const Side& side : sides) {
        // On the circle the product is a cosine around the angle at which the circle is farthest within.
        const double within = std::atan2(glm::dot(side.normal, circle.v), glm::dot(side.normal, circle.u));
        const double cosine = (side.level - glm::dot(side.normal, circle.middle)) / circle.radius;
        if (!(std::abs(cosine) < 1)) continue;
        for (const double aside : {-std::acos(cosine), std::acos(cosine)}) {
            const double angle = within + aside;
            angles.push_back(angle - glm::two_pi<double>() * std::floor(angle / glm::two_pi<double>()));
        }
    }
    if (angles.empty()) angles.push_back(0);
    std::ranges::sort(angles);
    angles.push_back(angles.front() + glm::two_pi<double>());
    return angles;
}

} // namespace

void addSphereCuts(const Triangle& triangle, std::uint32_t primitive, const dvec3& centreCentred, double radius, std::vector<SphereCut>& cuts) {
    const dvec3 front = frontOf(triangle);
    if (!(glm::length(front) > 0)) return;
    const dvec3 normal = glm::normalize(front);
    const double height = glm::dot(normal, centreCentred - triangle.a);
    if (!(std::abs(height) < radius)) return;
    const dvec3 u = perpendicularTo(normal);
    const Circle circle{centreCentred - height * normal, u, glm::cross(normal, u), std::sqrt((radius - height) * (radius + height))};
    const std::array<Side, 3> sides = sidesOf(triangle, front);
    const std::vector<double> angles = anglesAtSides(circle, sides);
    for (std::size_t i = 0; i + 1 < angles.size(); ++i) {
        const double width = angles[i + 1] - angles[i];
        const dvec3 middle = circle.place(angles[i] + 0.5 * width);
        const auto isWithin = [&](const Side& side) { return glm::dot(side.normal, middle) >= side.level; };
        if (!(width > 0) || !std::ranges::all_of(sides, isWithin)) continue;
        const int count = std::max(1, static_cast<int>(std::ceil(kChordsOfCircle * width / glm::two_pi<double>())));
        const double turn = width / count;
        // A sector of one radian has half the square of the radius, its chord's triangle that times sine over angle.
        const double stretch = std::sqrt(turn / std::sin(turn));
        for (int chord = 0; chord < count; ++chord)
            cuts.push_back({primitive, circle.place(angles[i] + chord * turn, stretch), circle.place(angles[i] + (chord + 1) * turn, stretch)});
    }
}

} // namespace shadowlab::trace
