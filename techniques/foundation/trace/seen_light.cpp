// SPDX-License-Identifier: MIT
#include "techniques/foundation/trace/seen_light.h"

#include <array>
#include <cmath>

#include <glm/gtc/constants.hpp>

#include "techniques/foundation/trace/uniform_pieces.h"

namespace shadowlab::trace {

namespace {

constexpr std::array<dvec2, 4> kSquare = {dvec2(-0.5, -0.5), dvec2(0.5, -0.5), dvec2(0.5, 0.5), dvec2(-0.5, 0.5)};

// A polygon stands for the disc, scaled so that it has the same area. What a straight edge cuts off then differs by what the
// two differ in up to where the edge meets the rim, at most 0.0204 (pi / n)^3 of the disc there: 2.4e-6 for 64 sides, twice
// that for both ends of an edge. A picture of visibility has steps of 4e-3.
constexpr std::size_t kSides = 64;

double circumradius() { return std::sqrt(glm::two_pi<double>() / (kSides * std::sin(glm::two_pi<double>() / kSides))); }

const std::array<dvec2, kSides>& disc() {
    static const std::array<dvec2, kSides> corners = [] {
        std::array<dvec2, kSides> made;
        for (std::size_t i = 0; i < kSides; ++i) {
            const double angle = glm::two_pi<double>() * static_cast<double>(i) / kSides;
            made[i] = circumradius() * dvec2(std::cos(angle), std::sin(angle));
        }
        return made;
    }();
    return corners;
}

} // namespace

std::optional<SeenLight> seenLight(const scene::Light& light, const dvec3& toLight) {
    if (light.type == scene::LightType::rect)
        return SeenLight{toLight, light.edgeUWorld, light.edgeVWorld, kSquare, dvec2(0.5), 1.0};
    if (light.type != scene::LightType::sphere) return std::nullopt;
    const double squaredDistance = glm::dot(toLight, toLight), squaredRadius = light.radius * light.radius;
    if (!(squaredDistance > squaredRadius)) return std::nullopt;
    const double nearer = 1 - squaredRadius / squaredDistance, radius = light.radius * std::sqrt(nearer);
    static const double area = areaOf(disc()); // pi, but for rounding: so that all of it is exactly one
    // Two axes across the way to the light; the one it goes least along is surely not parallel to it.
    const dvec3 way = glm::abs(toLight);
    const int least = way.x < way.y ? (way.x < way.z ? 0 : 2) : (way.y < way.z ? 1 : 2);
    dvec3 helper(0.0);
    helper[least] = 1;
    const dvec3 u = glm::normalize(glm::cross(toLight, helper)), v = glm::normalize(glm::cross(toLight, u));
    return SeenLight{nearer * toLight, radius * u, radius * v, disc(), dvec2(circumradius()), area};
}

} // namespace shadowlab::trace
