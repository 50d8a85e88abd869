// Reflection and refraction at a smooth surface: the directions of the two rays, and the share of light in each.
//
// Directions are unit vectors in world space. `u` is the direction of the ray; the normal lies on the side it comes from, so
// dot(u, normal) < 0. `ratio` is the index of refraction on that side over the one beyond. Snell's law gives the direction, A.
// Fresnel's formulas (1823) the shares, averaged over the two polarisations. The lecture has constant coefficients instead; C.
// Schlick, "An Inexpensive BRDF Model for Physically-based Rendering", Computer Graphics Forum 1994, has a polynomial that
// approximates Fresnel's.
// SPDX-License-Identifier: MIT
#pragma once
#include <optional>

#include "techniques/foundation/math/types.h"

namespace shadowlab::ray_tracing {

enum class Fresnel { exact, schlick, constant };

/// The reflected direction: R = u - 2 (u.N) N.
dvec3 reflected(const dvec3& u, const dvec3& normalWorld);

/// The refracted direction; nothing in total internal reflection.
std::optional<dvec3> refracted(const dvec3& u, const dvec3& normalWorld, double ratio);

/// The reflected share, 0..1, for the cosine of the angle of incidence; 1 in total internal reflection. The rest is transmitted.
double fresnelReflectance(double cosIncident, double ratio);

/// Schlick's approximation of the same. From the denser side it uses the angle on the thinner side, as it must.
double schlickReflectance(double cosIncident, double ratio);

/// The weights of the intensities of the reflection ray and the refraction ray.
struct Weights {
    double reflected = 0, transmitted = 0;
    bool isTotal = false; ///< total internal reflection
};

/// The weights for coefficients k_r (reflectivity) and k_t (transparency). With Fresnel::constant they are used as they are.
/// Otherwise their sum is divided by Fresnel's formulas; an opaque surface keeps its k_r, like metal. In total internal
/// reflection all of the sum is reflected.
Weights weightsOf(double reflectivity, double transparency, double cosIncident, double ratio, Fresnel kind);

} // namespace shadowlab::ray_tracing
