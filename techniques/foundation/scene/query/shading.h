// Shading in C++: the same formulas as in shaders/light.glsl and shaders/material.glsl; a test compares them.
//
// L = emission + ambient * diffuse + sum over lights of visibility * color * E * (diffuse/pi + specular * lobe),
// lobe = (s + 8) / (8 pi) * (n.h)^s: Lambert's law plus Blinn's highlight (1977), normalised so that the highlight's
// energy does not depend on its width (Akenine-Moeller, Haines, Hoffman, Real-Time Rendering).
// SPDX-License-Identifier: MIT
#pragma once
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

/// Radiance reflected toward the eye per unit irradiance; unit vectors, the normal on the viewer's side. `diffuse`: of the material, or
/// of the surface at that point where it has colours of its own (scene/model/surface_color.h).
dvec3 reflectance(const Material& material, const dvec3& diffuse, const dvec3& normalWorld, const dvec3& toLightWorld, const dvec3& toEyeWorld);
/// The same of a surface that has the material's colour all over.
dvec3 reflectance(const Material& material, const dvec3& normalWorld, const dvec3& toLightWorld, const dvec3& toEyeWorld);

} // namespace shadowlab::scene
