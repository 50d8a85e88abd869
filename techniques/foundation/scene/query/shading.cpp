// SPDX-License-Identifier: MIT
#include "techniques/foundation/scene/query/shading.h"

#include <algorithm>
#include <cmath>

#include <glm/gtc/constants.hpp>

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
    const dvec3 toLightWorld = towardLightWorld(light, positionWorld);
    double falloff = std::max(glm::dot(normalWorld, toLightWorld), 0.0);
    if (light.type != LightType::directional) {
        const dvec3 offsetWorld = light.positionWorld - positionWorld;
        falloff /= glm::dot(offsetWorld, offsetWorld);
    }
    if (light.type == LightType::rect) falloff *= std::max(glm::dot(-toLightWorld, rectNormalWorld(light)), 0.0);
    if (light.type == LightType::spot && light.edgeDegrees > 0.0) {
        const double radians = glm::pi<double>() / 180.0;
        const double angle = std::acos(std::clamp(glm::dot(-toLightWorld, light.directionWorld), -1.0, 1.0));
        falloff *= glm::smoothstep(0.0, light.edgeDegrees * radians, light.coneDegrees * radians / 2.0 - angle);
    }
    return dvec3(light.color) * pointIntensity(light) * falloff;
}

dvec3 reflectance(const Material& material, const dvec3& diffuse, const dvec3& normalWorld, const dvec3& toLightWorld, const dvec3& toEyeWorld) {
    const double pi = glm::pi<double>(), s = material.shininess;
    if (material.specular == vec3(0)) return diffuse / pi; // a power less for most
    const dvec3 halfwayWorld = glm::normalize(toLightWorld + toEyeWorld);
    const double cosHalfway = std::max(glm::dot(normalWorld, halfwayWorld), 0.0);
    const double lobe = (s + 8.0) / (8.0 * pi) * std::pow(cosHalfway, s);
    return diffuse / pi + dvec3(material.specular) * lobe;
}

dvec3 reflectance(const Material& material, const dvec3& normalWorld, const dvec3& toLightWorld, const dvec3& toEyeWorld) {
    return reflectance(material, dvec3(material.diffuse), normalWorld, toLightWorld, toEyeWorld);
}

} // namespace shadowlab::scene
