// SPDX-License-Identifier: MIT
#include "techniques/radiosity/lights/lamp_cover.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include <glm/gtc/constants.hpp>

#include "techniques/radiosity/lights/light_source.h"
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

/// The part of the patch that the rect lies in, or hangs close before, m^2.
double areaUnderRect(const Patch& patch, const scene::Light& rect, const dvec3& originWorld) {
    const dvec3 normal = scene::rectNormalWorld(rect);
    const Polygon lamp = outlineOf(rect, originWorld);
    if (!(glm::dot(normal, patch.normal) > 0) || !isCloseBefore(lamp, patch.plane())) return 0;
    const Polygon part = partWithin(lamp, normal, patch.polygon, kTouching * sizeOf(lamp));
    return part.isEmpty() ? 0 : glm::length(areaVector(part));
}

/// The part of the patch within the sphere, m^2.
double areaWithinSphere(const Patch& patch, const scene::Light& sphere, const dvec3& originWorld) {
    const dvec3 middle = sphere.positionWorld - originWorld;
    const double height = patch.plane().height(middle);
    const double squared = sphere.radius * sphere.radius - height * height; // of the radius of the circle in which the plane cuts it
    return squared > 0 ? areaWithinCircle(patch.polygon, middle - height * patch.normal, std::sqrt(squared)) : 0;
}

} // namespace

double coveredByLamps(const Patch& patch, std::span<const scene::Light> lights, const dvec3& originWorld) {
    double covered = 0;
    for (const scene::Light& light : lights)
        covered += light.type == scene::LightType::rect     ? areaUnderRect(patch, light, originWorld)
                   : light.type == scene::LightType::sphere ? areaWithinSphere(patch, light, originWorld)
                                                            : 0;
    return std::min(covered / patch.area, 1.0);
}

double caughtByLamps(std::span<const Patch> patches, std::span<const dvec3> radiosity, std::span<const scene::Light> lights,
                     const dvec3& originWorld) {
    std::vector<LightSource> lamps;
    for (scene::Light lamp : lights) {
        if (!scene::hasArea(lamp)) continue;
        lamp.intensity = 1 / glm::pi<double>(); // so that the irradiance by it is the form factor
        lamps.emplace_back(lamp, originWorld, Faces{});
        if (lamp.type != scene::LightType::rect) continue;
        std::swap(lamp.edgeUWorld, lamp.edgeVWorld); // its back
        lamps.emplace_back(lamp, originWorld, Faces{});
    }
    double sent = 0, caught = 0;
    for (std::size_t i = 0; i < patches.size(); ++i) {
        const double ofPatch = patches[i].area * luminance(radiosity[i]);
        sent += ofPatch;
        for (const LightSource& lamp : lamps)
            caught += ofPatch * lamp.irradiance(patches[i].centre, patches[i].normal);
    }
    return sent > 0 ? std::min(caught / sent, 1.0) : 0;
}

} // namespace shadowlab::radiosity
