// SPDX-License-Identifier: MIT
#include "techniques/foundation/trace/area/seen_light.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <glm/gtc/constants.hpp>

namespace shadowlab::trace {

namespace {

constexpr std::array<dvec2, 4> kSquare = {dvec2(-0.5, -0.5), dvec2(0.5, -0.5), dvec2(0.5, 0.5), dvec2(-0.5, 0.5)};

constexpr std::array<dvec2, 4> kAroundDisc = {dvec2(-1, -1), dvec2(1, -1), dvec2(1, 1), dvec2(-1, 1)};

} // namespace

// With d the way to a place of the disc, and t that to its rim, a tangent, the product of d with the way to the centre is t^2, and so is the
// product of the two distances to the sphere times the centre's: s = t^2 / (t^2 + sqrt(t^4 - d^2 t^2)).
double SeenLight::reach(dvec2 place) const {
    if (!isDisc) return 1;
    const double beforeRim = std::max(1 - glm::dot(place, place), 0.0) * glm::dot(axisU, axisU); // t^2 - d^2
    return 1 / (1 + std::sqrt(beforeRim / (glm::dot(axisU, axisU) + glm::dot(middle, middle))));
}

std::optional<SeenLight> seenLight(const scene::Light& light, const dvec3& toLight) {
    if (light.type == scene::LightType::rect)
        return SeenLight{toLight, light.edgeUWorld, light.edgeVWorld, false, kSquare, dvec2(0.5), 1.0};
    if (light.type != scene::LightType::sphere) return std::nullopt;
    const double squaredDistance = glm::dot(toLight, toLight), squaredRadius = light.radius * light.radius;
    if (!(squaredDistance > squaredRadius)) return std::nullopt;
    const double nearer = 1 - squaredRadius / squaredDistance, radius = light.radius * std::sqrt(nearer);
    // Two axes across the way to the light; the one it goes least along is surely not parallel to it.
    const dvec3 way = glm::abs(toLight);
    const int least = way.x < way.y ? (way.x < way.z ? 0 : 2) : (way.y < way.z ? 1 : 2);
    dvec3 helper(0.0);
    helper[least] = 1;
    const dvec3 u = glm::normalize(glm::cross(toLight, helper)), v = glm::normalize(glm::cross(toLight, u));
    return SeenLight{nearer * toLight, radius * u, radius * v, true, kAroundDisc, dvec2(1.0), glm::pi<double>()};
}

} // namespace shadowlab::trace
