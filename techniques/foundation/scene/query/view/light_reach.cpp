// SPDX-License-Identifier: MIT
#include "techniques/foundation/scene/query/view/light_reach.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <vector>

#include <glm/gtc/constants.hpp>

#include "techniques/foundation/scene/query/view/clip_polygon.h"
#include "techniques/foundation/scene/query/view/picture_part.h"

namespace shadowlab::scene {

namespace {

// For floors and walls the triangles are tested, as in visible_receivers.cpp, because their boxes would be mostly empty.
constexpr std::size_t kReachesEachTriangle = 16;
// Shaders decide in float, of points relative to the eye: some 1e-7 of the distances. Both are far more than that.
constexpr double kConeMargin = 1e-3;     // radians
constexpr double kDistanceMargin = 1e-5; // of the distance between eye, light and what is lit
// The four sides around a wider cone would be nearly one plane.
constexpr double kWidestHalfCone = 85 * glm::pi<double>() / 180;

/// The plane through a point, positive on the side of a unit normal, moved back by `slack`.
dvec4 planeThrough(const dvec3& pointWorld, const dvec3& normalWorld, double slack) {
    return {normalWorld, slack - glm::dot(normalWorld, pointWorld)};
}

/// Planes around the lit region, which lies on their positive sides.
std::vector<dvec4> planesAroundLight(const Light& light, double slack) {
    if (light.type == LightType::rect) return {planeThrough(light.positionWorld, rectNormalWorld(light), slack)};
    const double halfCone = light.coneDegrees * glm::pi<double>() / 360.0 + kConeMargin;
    if (light.type != LightType::spot || halfCone > kWidestHalfCone) return {};
    const dvec3 axis = light.directionWorld;
    const dvec3 aside = glm::normalize(glm::cross(axis, std::abs(axis.y) < 0.9 ? dvec3(0, 1, 0) : dvec3(1, 0, 0)));
    std::vector<dvec4> planes;
    for (const dvec3& side : {aside, -aside, glm::cross(axis, aside), -glm::cross(axis, aside)})
        planes.push_back(
            planeThrough(light.positionWorld, std::sin(halfCone) * axis + std::cos(halfCone) * side, slack));
    return planes;
}

bool anyIsBetween(const Object& object, std::span<const dvec4> planes) {
    const dmat4 worldFromMesh = scene::worldFromMesh(object);
    return std::ranges::any_of(object.mesh->triangles, [&](const uvec3& t) {
        std::vector<dvec4> polygon;
        for (const std::uint32_t v : {t.x, t.y, t.z})
            polygon.push_back(worldFromMesh * dvec4(dvec3(object.mesh->positionsMesh[v]), 1.0));
        for (const dvec4& plane : planes)
            polygon = clippedPolygon(polygon, plane);
        return !polygon.empty();
    });
}

bool isBeyond(const Bounds& box, const dvec4& plane) {
    for (int i = 0; i < 8; ++i)
        if (glm::dot(plane, dvec4(box.corner(i), 1.0)) > 0) return false;
    return true;
}

} // namespace

bool mayLight(const Scene& scene, const Light& light, std::span<const Bounds> bounds, const dvec3& eyeWorld,
              const dmat4& clipFromWorld, const PicturePart& part) {
    if (planesAroundLight(light, 0).empty()) return true;
    for (std::size_t o = 0; o < scene.objects.size(); ++o) {
        if (!mayTouch(bounds[o], clipFromWorld, part)) continue;
        const double extent = glm::length(bounds[o].upperWorld - bounds[o].lowerWorld) +
                              glm::length(bounds[o].lowerWorld - light.positionWorld) +
                              glm::length(bounds[o].lowerWorld - eyeWorld);
        std::vector<dvec4> planes = planesAroundLight(light, kDistanceMargin * extent);
        if (std::ranges::any_of(planes, [&](const dvec4& plane) { return isBeyond(bounds[o], plane); })) continue;
        const Object& object = scene.objects[o];
        if (object.mesh->triangles.size() > kReachesEachTriangle) return true;
        std::ranges::copy(planesWorld(clipFromWorld, part), std::back_inserter(planes));
        if (anyIsBetween(object, planes)) return true;
    }
    return false;
}

} // namespace shadowlab::scene
