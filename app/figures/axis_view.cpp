// SPDX-License-Identifier: MIT
#include "app/figures/axis_view.h"

#include <cmath>

namespace shadowlab::figures {

int axisAcross(const dvec3& rayWorld) {
    const dvec3 along = glm::abs(rayWorld);
    return along.x <= along.y ? (along.x <= along.z ? 0 : 2) : (along.y <= along.z ? 1 : 2);
}

ParallelView viewAlong(int axis, const scene::Camera& camera) {
    const dvec3 forward = camera.targetWorld - camera.positionWorld;
    if (axis == 1) {
        // The axis that the camera looks along more leads upward on the sheet.
        const bool alongZ = std::abs(forward.z) >= std::abs(forward.x);
        const dvec3 up = alongZ ? dvec3(0, 0, forward.z > 0 ? 1 : -1) : dvec3(forward.x > 0 ? 1 : -1, 0, 0);
        return {dvec3(0, 1, 0), up};
    }
    dvec3 toward(0.0);
    toward[axis] = 1;
    // So that the ray goes to the right: the viewer stands on the camera's right side.
    if (glm::dot(toward, glm::cross(forward, dvec3(0, 1, 0))) < 0) toward = -toward;
    return {toward, dvec3(0, 1, 0)};
}

drawing::Box rectangleOf(const ParallelView& view, const dvec3& lowerWorld, const dvec3& upperWorld) {
    const dvec2 a = view(lowerWorld), b = view(upperWorld);
    return {glm::min(a, b), glm::abs(a - b)};
}

std::string axisWords(int axis) {
    return axis == 1 ? "from above" : axis == 0 ? "along the x axis" : "along the z axis";
}

} // namespace shadowlab::figures
