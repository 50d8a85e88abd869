// SPDX-License-Identifier: MIT
#include "techniques/ray_tracing/sampling/analytic_lights.h"

#include <glm/gtc/constants.hpp>

#include "techniques/foundation/scene/query/shading.h"

namespace shadowlab::ray_tracing {

dvec3 reflectedOf(const scene::Light& light, double irradiance, const scene::Material& material,
                  const dvec3& positionWorld, const dvec3& normalWorld, const dvec3& toViewerWorld) {
    return glm::pi<double>() * irradiance * light.intensity * dvec3(light.color) *
           scene::reflectance(material, normalWorld, scene::towardLightWorld(light, positionWorld), toViewerWorld);
}

} // namespace shadowlab::ray_tracing
