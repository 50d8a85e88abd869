// SPDX-License-Identifier: MIT
#include "techniques/foundation/scene/query/shading.h"

#include <cmath>

namespace shadowlab::scene {

dvec3 towardLightWorld(const Light& light, const dvec3& positionWorld) {
    if (light.type == LightType::directional) return -light.directionWorld;
    return glm::normalize(light.positionWorld - positionWorld);
}

bool shinesEverywhere(const Light& light) { return light.type != LightType::spot && light.type != LightType::rect; }

bool lightShinesTo(const Light& light, const dvec3& positionWorld) {
    const dvec3 fromLightWorld = -towardLightWorld(light, positionWorld);
    if (light.type == LightType::spot)
        return glm::dot(fromLightWorld, light.directionWorld) > std::cos(light.coneDegrees * glm::pi<double>() / 360.0);
    if (light.type == LightType::rect) return glm::dot(fromLightWorld, rectNormalWorld(light)) > 0.0;
    return true;
}

dvec3 irradiance(const Light& light, const dvec3& positionWorld, const dvec3& normalWorld) {
    const dvec3 offsetWorld = light.positionWorld - positionWorld;
    return dvec3(light.color) * pointIntensity(light) *
           falloff(light, normalWorld, towardLightWorld(light, positionWorld), glm::dot(offsetWorld, offsetWorld));
}

} // namespace shadowlab::scene
