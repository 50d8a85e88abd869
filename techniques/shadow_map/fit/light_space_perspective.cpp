// SPDX-License-Identifier: MIT
#include "techniques/shadow_map/fit/light_space_perspective.h"

#include <algorithm>
#include <cmath>

namespace shadowlab::shadow_map {

namespace {

// Below this sine the light comes so nearly along the view that the perspective would be weaker than rounding.
constexpr double kLeastSine = 1e-3;

dvec3 viewDirection(const scene::Camera& camera) { return glm::normalize(camera.targetWorld - camera.positionWorld); }

} // namespace

dmat4 lookAlongForWarp(const dvec3& forward, const scene::Camera& camera) {
    const dvec3 view = viewDirection(camera);
    return glm::length(glm::cross(forward, view)) > kLeastSine ? lookAlong(forward, view) : lookAlong(forward);
}

dmat4 warpedProjection(const Box& box, const scene::Light& light, const FitEye& eye, double share) {
    const double sine = glm::length(glm::cross(light.directionWorld, viewDirection(eye.camera)));
    const double depth = box.upper.y - box.lower.y; // of the warp's frustum: along the light camera's y axis
    dmat4 warp(1.0);
    if (sine > kLeastSine) {
        const double zNear = eye.camera.near, zFar = zNear + depth * sine;
        const double n = (zNear + std::sqrt(zNear * zFar)) / sine;
        // w is the distance from the projection centre, n before the box; y goes from -1 at n to 1 at n + depth, and lines
        // stay lines.
        const double toCentre = n - box.lower.y, middle = 0.5 * (box.lower.x + box.upper.x);
        warp = dmat4(0.0);
        warp[0][0] = 1;
        warp[3][0] = -middle;
        warp[1][1] = (2 * n + depth) / depth;
        warp[3][1] = warp[1][1] * toCentre - 2 * n * (n + depth) / depth;
        warp[2][2] = 1;
        warp[3][2] = -0.5 * (box.lower.z + box.upper.z);
        warp[1][3] = 1;
        warp[3][3] = toCentre;
    }
    // What it makes of the box, cut out: its corners say how large that is.
    Box warped;
    for (int i = 0; i < 8; ++i) {
        const dvec4 corner = warp * dvec4(box.corner(i), 1.0);
        warped.include(dvec3(corner) / corner.w);
    }
    const dvec3 extent = warped.upper - warped.lower;
    const dvec3 margin(share * extent.x, share * extent.y, 1e-3 * extent.z);
    warped.lower -= margin;
    warped.upper += margin;
    return parallelProjection(warped) * warp;
}

} // namespace shadowlab::shadow_map
