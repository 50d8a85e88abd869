// What a smooth surface does to a ray: it throws a part of the light back and lets the rest through, bent.
//
// Directions are unit vectors in world space. `u` is the way the ray travels; the normal stands on the side it comes from,
// so dot(u, normal) < 0. `ratio` is the index of refraction on that side over the one beyond.
// Snell's law for the way, A. Fresnel's formulas (1823) for the shares, averaged over the two polarisations. The lecture
// has constant coefficients instead; C. Schlick, "An Inexpensive BRDF Model for Physically-based Rendering", Computer
// Graphics Forum 1994, has a polynomial in between.
// SPDX-License-Identifier: MIT
#pragma once
#include <optional>

#include "techniques/foundation/math/types.h"

namespace shadowlab::ray_tracing {

enum class Fresnel { exact, schlick, constant };

/// Where a mirror sends the ray: R = u - 2 (u.N) N.
dvec3 reflected(const dvec3& u, const dvec3& normalWorld);

/// Where the ray goes beyond the surface; nothing where no light gets through (total internal reflection).
std::optional<dvec3> refracted(const dvec3& u, const dvec3& normalWorld, double ratio);

/// The share that is thrown back, 0..1, of a ray that meets the surface under `cosIncident`; 1 in total reflection. The rest
/// goes through.
double fresnelReflectance(double cosIncident, double ratio);

/// Schlick's polynomial for the same. From the denser side it is given the angle on the thinner one, as it must.
double schlickReflectance(double cosIncident, double ratio);

/// What of the intensity that a reflection ray and a refraction ray bring counts at the surface.
struct Weights {
    double reflected = 0, transmitted = 0;
    bool isTotal = false; ///< total internal reflection
};

/// Of a surface that mirrors a share k_r and lets a share k_t pass. Constant coefficients are taken as they are. What
/// Fresnel says divides their sum anew, as the angle wants it; a surface that lets nothing pass keeps its k_r, like metal.
/// In total reflection all of the sum is thrown back.
Weights weightsOf(double reflectivity, double transparency, double cosIncident, double ratio, Fresnel kind);

} // namespace shadowlab::ray_tracing
