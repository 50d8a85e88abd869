// SPDX-License-Identifier: MIT
#include "app/film/orbit.h"

#include <cmath>

#include <glm/gtc/constants.hpp>

namespace shadowlab::film {

namespace {

/// Rotation about world +y; the sense is that of the right hand.
dmat3 aboutY(double degrees) {
    const double radians = degrees * glm::pi<double>() / 180.0, c = std::cos(radians), s = std::sin(radians);
    return {dvec3(c, 0, -s), dvec3(0, 1, 0), dvec3(s, 0, c)};
}

} // namespace

scene::Snapshot withLightsTurned(const scene::Snapshot& snapshot, double degrees) {
    if (degrees == 0) return snapshot;
    auto scene = std::make_shared<scene::Scene>(*snapshot);
    const dmat3 rotation = aboutY(degrees);
    const dvec3 pivotWorld = scene->camera.targetWorld;
    for (scene::Light& light : scene->lights) {
        light.positionWorld = pivotWorld + rotation * (light.positionWorld - pivotWorld);
        light.directionWorld = rotation * light.directionWorld;
        light.edgeUWorld = rotation * light.edgeUWorld;
        light.edgeVWorld = rotation * light.edgeVWorld;
    }
    for (scene::Object& object : scene->objects) {
        if (object.emitterOfLight < 0) continue;
        dmat4 turned = dmat4(rotation) * object.worldFromObject;
        turned[3] += dvec4(pivotWorld - rotation * pivotWorld, 0.0);
        object.worldFromObject = turned;
        scene->revisions.transforms = scene::newRevision();
    }
    scene->revisions.lights = scene::newRevision();
    return scene;
}

scene::Camera turned(const scene::Camera& camera, double degrees) {
    scene::Camera result = camera;
    const dmat3 rotation = aboutY(degrees);
    result.positionWorld = camera.targetWorld + rotation * (camera.positionWorld - camera.targetWorld);
    result.upWorld = rotation * camera.upWorld;
    return result;
}

} // namespace shadowlab::film
