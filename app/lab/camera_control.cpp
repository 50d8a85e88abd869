// SPDX-License-Identifier: MIT
#include "app/lab/camera_control.h"

#include <algorithm>
#include <cmath>

namespace shadowlab::lab {

namespace {

constexpr double kSteepestDegrees = 89; ///< of the view against the horizon; at 90 "right" would mean nothing
constexpr double kNearestTarget = 1e-3, kFarthestTarget = 1e7; ///< metres; beyond, a wheel would lose the scene

/// `direction` turned about the camera's up direction, then raised toward it as far as allowed.
dvec3 swung(const scene::Camera& camera, const dvec3& direction, double aroundDegrees, double raiseDegrees) {
    const dvec3 upWorld = glm::normalize(camera.upWorld);
    const double length = glm::length(direction);
    const double height = glm::dot(direction, upWorld);
    const double elevation = glm::degrees(std::asin(std::clamp(height / length, -1.0, 1.0)));
    const double raised = glm::radians(std::clamp(elevation + raiseDegrees, -kSteepestDegrees, kSteepestDegrees));
    const dvec3 level = direction - height * upWorld;
    const dvec3 along = glm::normalize(level), across = glm::cross(upWorld, along);
    const double around = glm::radians(aroundDegrees);
    return length *
           (std::cos(raised) * (std::cos(around) * along + std::sin(around) * across) + std::sin(raised) * upWorld);
}

} // namespace

PictureAxes pictureAxes(const scene::Camera& camera) {
    const dvec3 forwardWorld = glm::normalize(camera.targetWorld - camera.positionWorld);
    const dvec3 rightWorld = glm::normalize(glm::cross(forwardWorld, camera.upWorld));
    return {rightWorld, glm::cross(rightWorld, forwardWorld), forwardWorld};
}

scene::Camera orbited(scene::Camera camera, double rightDegrees, double overDegrees) {
    const dvec3 toEyeWorld = camera.positionWorld - camera.targetWorld;
    camera.positionWorld = camera.targetWorld + swung(camera, toEyeWorld, rightDegrees, overDegrees);
    return camera;
}

scene::Camera turnedHead(scene::Camera camera, double rightDegrees, double upDegrees) {
    const dvec3 toTargetWorld = camera.targetWorld - camera.positionWorld;
    camera.targetWorld = camera.positionWorld + swung(camera, toTargetWorld, -rightDegrees, upDegrees);
    return camera;
}

scene::Camera panned(scene::Camera camera, double right, double up) {
    const PictureAxes axes = pictureAxes(camera);
    const double heightAtTarget = 2 * targetDistance(camera) * std::tan(glm::radians(camera.fovYDegrees) / 2);
    // What is seen goes one way when the camera goes the other.
    const dvec3 shiftWorld = -heightAtTarget * (right * axes.rightWorld + up * axes.upWorld);
    camera.positionWorld += shiftWorld;
    camera.targetWorld += shiftWorld;
    return camera;
}

scene::Camera zoomed(scene::Camera camera, double factor) {
    const dvec3 toEyeWorld = camera.positionWorld - camera.targetWorld;
    const double distance = glm::length(toEyeWorld);
    const double wanted = std::clamp(distance * factor, kNearestTarget, kFarthestTarget);
    camera.positionWorld = camera.targetWorld + toEyeWorld * (wanted / distance);
    return camera;
}

scene::Camera flown(scene::Camera camera, double right, double up, double forward) {
    const PictureAxes axes = pictureAxes(camera);
    const dvec3 shiftWorld = right * axes.rightWorld + up * axes.upWorld + forward * axes.forwardWorld;
    camera.positionWorld += shiftWorld;
    camera.targetWorld += shiftWorld;
    return camera;
}

double targetDistance(const scene::Camera& camera) { return glm::length(camera.targetWorld - camera.positionWorld); }

} // namespace shadowlab::lab
