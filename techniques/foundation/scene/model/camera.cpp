// SPDX-License-Identifier: MIT
#include "techniques/foundation/scene/model/camera.h"

#include <cmath>

#include <glm/gtc/constants.hpp>

namespace shadowlab::scene {

namespace {

double tanHalfFovY(const Camera& camera) { return std::tan(camera.fovYDegrees * glm::pi<double>() / 360.0); }

/// Rows of the rotation: right, up and backward, each a unit vector in world space.
dmat3 worldFromViewRotation(const Camera& camera) {
    const dvec3 backwardWorld = glm::normalize(camera.positionWorld - camera.targetWorld);
    const dvec3 rightWorld = glm::normalize(glm::cross(camera.upWorld, backwardWorld));
    return {rightWorld, glm::cross(backwardWorld, rightWorld), backwardWorld};
}

} // namespace

bool hasView(const Camera& camera) {
    const dvec3 view = camera.targetWorld - camera.positionWorld, &up = camera.upWorld;
    if (!(glm::dot(view, view) > 0.0) || !(glm::dot(up, up) > 0.0)) return false;
    return glm::length(glm::cross(glm::normalize(view), glm::normalize(up))) >= 1e-6;
}

dmat4 viewFromWorld(const Camera& camera) {
    const dmat3 viewFromWorldRotation = glm::transpose(worldFromViewRotation(camera));
    dmat4 viewFromWorld(viewFromWorldRotation);
    viewFromWorld[3] = dvec4(-(viewFromWorldRotation * camera.positionWorld), 1.0);
    return viewFromWorld;
}

dmat4 clipFromView(const Camera& camera, double aspect) {
    const double scaleY = 1.0 / tanHalfFovY(camera);
    dmat4 clipFromView(0.0);
    clipFromView[0][0] = scaleY / aspect;
    clipFromView[1][1] = scaleY;
    clipFromView[2][2] = -1.0;
    clipFromView[2][3] = -1.0;
    clipFromView[3][2] = -2.0 * camera.near;
    return clipFromView;
}

dvec3 rayDirectionWorld(const Camera& camera, dvec2 pixel, ivec2 size) {
    const double halfHeight = tanHalfFovY(camera);
    const double halfWidth = halfHeight * size.x / size.y;
    const dvec3 directionView((2.0 * pixel.x / size.x - 1.0) * halfWidth, (1.0 - 2.0 * pixel.y / size.y) * halfHeight,
                              -1.0);
    return glm::normalize(worldFromViewRotation(camera) * directionView);
}

std::array<dvec3, 4> viewCorners(const Camera& camera, double aspect, double depth) {
    const dmat3 worldFromView = worldFromViewRotation(camera);
    const double y = depth * tanHalfFovY(camera), x = y * aspect;
    std::array<dvec3, 4> corners = {dvec3(-x, y, -depth), dvec3(x, y, -depth), dvec3(x, -y, -depth),
                                    dvec3(-x, -y, -depth)};
    for (dvec3& corner : corners)
        corner = camera.positionWorld + worldFromView * corner;
    return corners;
}

} // namespace shadowlab::scene
