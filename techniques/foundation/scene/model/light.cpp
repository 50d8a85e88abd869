// SPDX-License-Identifier: MIT
#include "techniques/foundation/scene/model/light.h"

#include <glm/gtc/constants.hpp>

namespace shadowlab::scene {

std::string_view toText(LightType type) {
    switch (type) {
    case LightType::point: return "point";
    case LightType::directional: return "directional";
    case LightType::spot: return "spot";
    case LightType::rect: return "rect";
    case LightType::sphere: return "sphere";
    }
    return "";
}

dvec4 homogeneousPositionWorld(const Light& light) {
    if (light.type == LightType::directional) return {-light.directionWorld, 0.0};
    return {light.positionWorld, 1.0};
}

bool edgesSpan(const Light& light) {
    const dvec3 &u = light.edgeUWorld, &v = light.edgeVWorld;
    if (!(glm::dot(u, u) > 0.0) || !(glm::dot(v, v) > 0.0)) return false;
    // A billionth of a radian: ten million times the rounding of double.
    return glm::length(glm::cross(glm::normalize(u), glm::normalize(v))) >= 1e-9;
}

dvec3 rectNormalWorld(const Light& light) { return glm::normalize(glm::cross(light.edgeUWorld, light.edgeVWorld)); }

bool hasArea(const Light& light) { return light.type == LightType::rect || light.type == LightType::sphere; }

double pointIntensity(const Light& light) {
    switch (light.type) {
    case LightType::rect: return light.intensity * glm::length(glm::cross(light.edgeUWorld, light.edgeVWorld));
    case LightType::sphere: return light.intensity * glm::pi<double>() * light.radius * light.radius;
    default: return light.intensity;
    }
}

} // namespace shadowlab::scene
