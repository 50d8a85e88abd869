// SPDX-License-Identifier: MIT
#include "techniques/radiosity/lights/lamp_cover.h"

#include <algorithm>

#include "techniques/radiosity/patches/contacts.h"

namespace shadowlab::radiosity {

namespace {

/// Counter-clockwise seen from where it shines; centred space.
Polygon outlineOf(const scene::Light& rect, const dvec3& originWorld) {
    const dvec3 middle = rect.positionWorld - originWorld, u = 0.5 * rect.edgeUWorld, v = 0.5 * rect.edgeVWorld;
    return {middle - u - v, middle + u - v, middle + u + v, middle - u + v};
}

bool isCloseBefore(const Polygon& lamp, const Plane& plane) {
    const double size = sizeOf(lamp), touching = kTouching * size;
    return std::ranges::all_of(lamp.corners(), [&](const dvec3& corner) {
        const double height = plane.height(corner);
        return height >= -touching && height <= kCloseAbove * size;
    });
}

/// The part of a patch that lies straight behind the lamp.
Polygon partBehind(const Polygon& lamp, const dvec3& lampNormal, Polygon part) {
    for (std::size_t i = 0; i < lamp.count(); ++i) {
        const dvec3 inward = glm::normalize(glm::cross(lampNormal, lamp[(i + 1) % lamp.count()] - lamp[i]));
        if (!part.isEmpty()) part = partBefore({lamp[i], inward}, part, kTouching * sizeOf(lamp));
    }
    return part;
}

} // namespace

double coveredByLamps(const Patch& patch, std::span<const scene::Light> lights, const dvec3& originWorld) {
    double covered = 0;
    for (const scene::Light& light : lights) {
        if (light.type != scene::LightType::rect) continue;
        const dvec3 normal = scene::rectNormalWorld(light);
        const Polygon lamp = outlineOf(light, originWorld);
        if (!(glm::dot(normal, patch.normal) > 0) || !isCloseBefore(lamp, patch.plane())) continue;
        if (const Polygon part = partBehind(lamp, normal, patch.polygon); !part.isEmpty()) covered += glm::length(areaVector(part));
    }
    return std::min(covered / patch.area, 1.0);
}

} // namespace shadowlab::radiosity
