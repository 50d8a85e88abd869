// Lights in rooms, for tests.
// SPDX-License-Identifier: MIT
#pragma once
#include "techniques/radiosity/lights/light_source.h"
#include "tests/radiosity/scene_room.h"

namespace shadowlab::testing {

inline scene::Light rectLight(const dvec3& middle, const dvec3& u, const dvec3& v, double radiance) {
    scene::Light light;
    light.type = scene::LightType::rect;
    light.positionWorld = middle;
    light.edgeUWorld = u;
    light.edgeVWorld = v;
    light.intensity = radiance;
    return light;
}

inline scene::Light sphereLight(const dvec3& middle, double radius, double radiance) {
    scene::Light light;
    light.type = scene::LightType::sphere;
    light.positionWorld = middle;
    light.radius = radius;
    light.intensity = radiance;
    return light;
}

inline scene::Light spotLight(const dvec3& position, const dvec3& direction, double cone, double edge) {
    scene::Light light = pointLight(position);
    light.type = scene::LightType::spot;
    light.directionWorld = glm::normalize(direction);
    light.coneDegrees = cone;
    light.edgeDegrees = edge;
    return light;
}

inline radiosity::LightSource sourceOf(const scene::Light& light, const Room& room) {
    return {light, room.originWorld, room.faces};
}

/// A square of that side in y = 0 about the origin, facing up; perhaps more.
inline scene::Scene squareScene(double side) {
    scene::Scene scene;
    scene.materials.emplace_back();
    addObject(scene, scene::makeQuad({side, side}));
    return scene;
}

} // namespace shadowlab::testing
