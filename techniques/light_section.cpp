// SPDX-License-Identifier: MIT
#include "techniques/light_section.h"

#include <cmath>

namespace shadowlab {

namespace {

// Below this sine two directions are one, for a drawing: some third of a degree. Nearer, the figure would be a line.
constexpr double kAligned = 0.005;
// Below this share of its length the scene's up points out of the paper.
constexpr double kUpright = 0.2;

dvec3 anyAcross(const dvec3& direction) {
    return glm::normalize(glm::cross(direction, std::abs(direction.y) > 0.9 ? dvec3(1, 0, 0) : dvec3(0, 1, 0)));
}

} // namespace

LightSection lightSection(const dvec3& eyeWorld, const dvec3& pointWorld, const dvec4& lightWorld,
                          const dvec3& normalWorld) {
    const dvec3 toEye = glm::normalize(eyeWorld - pointWorld);
    const dvec3 way = dvec3(lightWorld) - pointWorld * lightWorld.w;
    const dvec3 toLight = glm::length(way) > 0 ? glm::normalize(way) : toEye;
    LightSection section;
    section.originWorld = pointWorld;
    dvec3 across = glm::cross(toEye, toLight);
    section.isChosen = glm::length(across) < kAligned;
    if (section.isChosen) across = glm::cross(toEye, normalWorld);
    across = glm::length(across) < kAligned ? anyAcross(toEye) : glm::normalize(across);

    const auto inPlane = [&](const dvec3& direction) { return direction - glm::dot(direction, across) * across; };
    dvec3 up = inPlane(dvec3(0, 1, 0));
    if (glm::length(up) < kUpright) up = inPlane(normalWorld);
    if (glm::length(up) < kUpright) up = inPlane(toLight);
    section.upWorld = glm::normalize(up);
    section.rightWorld = glm::normalize(glm::cross(section.upWorld, across));
    if (glm::dot(toEye, section.rightWorld) > 0) section.rightWorld = -section.rightWorld;
    return section;
}

std::optional<std::array<dvec2, 2>> cutBy(const LightSection& section, const std::array<dvec3, 3>& cornersWorld) {
    const dvec3 normal = section.normalWorld();
    std::array<double, 3> heights{};
    for (std::size_t i = 0; i < 3; ++i)
        heights[i] = glm::dot(cornersWorld[i] - section.originWorld, normal);
    std::array<dvec2, 2> cut{};
    std::size_t found = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        // From the lower to the higher end, whichever way the triangle runs: its neighbour's cut is the same point.
        std::size_t a = i, b = (i + 1) % 3;
        if ((heights[a] < 0) == (heights[b] < 0)) continue;
        if (heights[a] > heights[b]) std::swap(a, b);
        const double share = heights[a] / (heights[a] - heights[b]);
        if (found < 2) cut[found++] = section.of(glm::mix(cornersWorld[a], cornersWorld[b], share));
    }
    if (found < 2) return std::nullopt;
    return cut;
}

} // namespace shadowlab
