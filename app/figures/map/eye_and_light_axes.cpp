// SPDX-License-Identifier: MIT
#include "app/figures/map/eye_and_light_axes.h"

#include <algorithm>
#include <cmath>

#include <glm/gtc/constants.hpp>

#include "techniques/probed/map_probe.h"

namespace shadowlab::figures {

MapAxes axesOf(const MapProbe& map) {
    const dmat4 rows = glm::transpose(map.lightClipFromLightRelative);
    const dvec3 w(rows[3]);
    MapAxes axes;
    axes.depthWorld =
        glm::normalize(glm::length(w) > 1e-12 ? w : dvec3(rows[2])); // of a parallel map w is 1 everywhere
    const auto across = [&](const dvec3& row) {
        return glm::normalize(row - glm::dot(row, axes.depthWorld) * axes.depthWorld);
    };
    axes.acrossWorld = across(dvec3(rows[0]));
    axes.upWorld = across(dvec3(rows[1]));
    return axes;
}

std::array<dvec2, 2> viewWedge(const scene::Camera& camera, ivec2 size, const LightSection& section, dvec2 eye) {
    const dvec2 u = -glm::normalize(eye), v(-u.y, u.x);
    const auto corners = scene::viewCorners(camera, static_cast<double>(size.x) / size.y, 1.0);
    double low = -glm::half_pi<double>(), high = glm::half_pi<double>();
    for (std::size_t i = 0; i < 4; ++i) {
        dvec3 normal = glm::cross(corners[i] - camera.positionWorld, corners[(i + 1) % 4] - camera.positionWorld);
        if (glm::dot(normal, camera.targetWorld - camera.positionWorld) < 0) normal = -normal;
        const dvec2 flat = section.ofDirection(normal);
        const double phi = std::atan2(glm::dot(flat, v), glm::dot(flat, u));
        low = std::max(low, phi - glm::half_pi<double>());
        high = std::min(high, phi + glm::half_pi<double>());
    }
    const auto at = [&](double angle) { return std::cos(angle) * u + std::sin(angle) * v; };
    return {at(low), at(high)};
}

} // namespace shadowlab::figures
