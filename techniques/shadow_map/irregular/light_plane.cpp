// SPDX-License-Identifier: MIT
#include "techniques/shadow_map/irregular/light_plane.h"

#include <cmath>

namespace shadowlab::shadow_map {

namespace {

/// Two axes at right angles to a unit direction and to each other. Which way they run does not matter.
dmat3 axesAround(const dvec3& direction) {
    const dvec3 size = glm::abs(direction);
    const dvec3 aside = size.y <= size.x && size.y <= size.z ? dvec3(0, 1, 0)
                        : size.x <= size.z                   ? dvec3(1, 0, 0)
                                                             : dvec3(0, 0, 1);
    const dvec3 right = glm::normalize(glm::cross(aside, direction));
    return glm::transpose(dmat3(right, glm::cross(direction, right), direction));
}

// Nearer to the light than this nothing has a place: one over the depth must be a float.
constexpr double kLeastDepth = 1e-30;

} // namespace

LightPlanes LightPlanes::one(const scene::Light& light, const dvec3& originWorld, const dvec3& middleCentred) {
    LightPlanes planes;
    LightPlane plane;
    plane.parallel = light.type == scene::LightType::directional;
    if (!plane.parallel) plane.originCentred = light.positionWorld - originWorld;
    const dvec3 direction = plane.parallel ? -light.directionWorld : middleCentred - plane.originCentred;
    const double length = glm::length(direction);
    plane.planeFromCentred = axesAround(length > 0 ? direction / length : dvec3(0, -1, 0));
    planes.planes_.push_back(plane);
    return planes;
}

LightPlanes LightPlanes::cube(const scene::Light& light, const dvec3& originWorld) {
    LightPlanes planes;
    for (int face = 0; face < 6; ++face) {
        dvec3 direction(0.0);
        direction[face / 2] = face % 2 ? -1 : 1;
        planes.planes_.push_back({false, light.positionWorld - originWorld, axesAround(direction)});
    }
    return planes;
}

int LightPlanes::planeOf(const dvec3& positionCentred) const {
    const LightPlane& first = planes_.front();
    const dvec3 p = positionCentred - first.originCentred, size = glm::abs(p);
    if (!std::isfinite(size.x + size.y + size.z)) return -1;
    if (first.parallel) return 0;
    if (planes_.size() == 1) {
        const dvec3 q = first.planeFromCentred * p;
        const bool within =
            q.z > kLeastDepth && std::abs(q.x) <= kWidestPlane * q.z && std::abs(q.y) <= kWidestPlane * q.z;
        return within ? 0 : -1;
    }
    const int axis = size.x > size.y ? (size.x > size.z ? 0 : 2) : (size.y > size.z ? 1 : 2);
    return size[axis] > kLeastDepth ? 2 * axis + (p[axis] < 0) : -1;
}

} // namespace shadowlab::shadow_map
