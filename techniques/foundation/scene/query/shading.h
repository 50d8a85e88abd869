// Shading in C++: the same formulas as in shaders/light.glsl and shaders/material.glsl; a test compares them.
//
// L = emission + ambient * diffuse + sum over lights of visibility * color * E * (diffuse/pi + specular * lobe),
// lobe = (s + 8) / (8 pi) * (n.h)^s: Lambert's law plus Blinn's highlight (1977), normalised so that the highlight's
// energy does not depend on its width (Akenine-Moeller, Haines, Hoffman, Real-Time Rendering).
// SPDX-License-Identifier: MIT
#pragma once
#include <algorithm>
#include <cmath>

#include <glm/gtc/constants.hpp>

#include "techniques/foundation/scene/model/scene.h"

namespace shadowlab::scene {

/// Unit vector from the surface toward the light (its centre).
dvec3 towardLightWorld(const Light& light, const dvec3& positionWorld);

/// True for lights that shine in every direction: all but spot and rect.
bool shinesEverywhere(const Light& light);

/// Is the point inside a spot's cone, or on the shining side of a rect? True for the other lights.
bool lightShinesTo(const Light& light, const dvec3& positionWorld);

/// Irradiance of the unshadowed light on a surface with that unit normal, per colour: color * E.
dvec3 irradiance(const Light& light, const dvec3& positionWorld, const dvec3& normalWorld);

// Both in double, for what is to be exact, and in float, for what is seen.

/// What is left of the light's intensity on a surface with that normal: irradiance per unit of color * pointIntensity(light). Unit
/// vectors; the distance is to the light, and of no account for a directional one.
template <typename Real>
Real falloff(const Light& light, const glm::vec<3, Real>& normalWorld, const glm::vec<3, Real>& toLightWorld, Real distanceSquared) {
    using Vec = glm::vec<3, Real>;
    Real falloff = std::max(glm::dot(normalWorld, toLightWorld), Real(0));
    if (light.type != LightType::directional) falloff /= distanceSquared;
    if (light.type == LightType::rect) falloff *= std::max(glm::dot(-toLightWorld, Vec(rectNormalWorld(light))), Real(0));
    if (light.type == LightType::spot && light.edgeDegrees > 0.0) {
        const Real radians = glm::pi<Real>() / Real(180);
        const Real angle = std::acos(std::clamp(glm::dot(-toLightWorld, Vec(light.directionWorld)), Real(-1), Real(1)));
        falloff *= glm::smoothstep(Real(0), Real(light.edgeDegrees) * radians, Real(light.coneDegrees) * radians / Real(2) - angle);
    }
    return falloff;
}

/// Radiance reflected toward the eye per unit irradiance; unit vectors, the normal on the viewer's side.
template <typename Real>
glm::vec<3, Real> reflectance(const Material& material, const glm::vec<3, Real>& normalWorld, const glm::vec<3, Real>& toLightWorld,
                              const glm::vec<3, Real>& toEyeWorld) {
    using Vec = glm::vec<3, Real>;
    const Real pi = glm::pi<Real>(), s = Real(material.shininess);
    if (material.specular == vec3(0)) return Vec(material.diffuse) / pi; // a power less for most
    const Vec halfwayWorld = glm::normalize(toLightWorld + toEyeWorld);
    const Real cosHalfway = std::max(glm::dot(normalWorld, halfwayWorld), Real(0));
    const Real lobe = (s + Real(8)) / (Real(8) * pi) * std::pow(cosHalfway, s);
    return Vec(material.diffuse) / pi + Vec(material.specular) * lobe;
}

} // namespace shadowlab::scene
