// Directions that a rough surface sends a ray in: a lobe around the direction of a perfect one.
//
// The lobe is a power of the cosine of the angle to its axis, as in Phong's highlight (1975); the power is given by the angle
// at which half is left. At 60 degrees the power is 1, Lambert's law about that axis. R. L. Cook, T. Porter and L. Carpenter,
// "Distributed Ray Tracing", SIGGRAPH 1984.
// SPDX-License-Identifier: MIT
#pragma once
#include "techniques/foundation/math/types.h"

namespace shadowlab::ray_tracing {

/// n, with cos(halfDegrees)^n = 1/2. For an angle above 0 and below 90 degrees; at 90 it is 0, all directions of the half-space
/// alike.
double lobePower(double halfDegrees);

/// The direction that two numbers in [0, 1) stand for: chosen with a density of (n + 1) / (2 pi) cos^n. Unit vectors.
dvec3 lobeDirection(const dvec3& axis, double power, dvec2 numbers);

/// A disc of radius 1 evenly filled, neighbours staying neighbours. P. Shirley and K. Chiu, "A Low Distortion Map Between Disk
/// and Square", Journal of Graphics Tools 1997.
dvec2 onDisc(dvec2 numbers);

} // namespace shadowlab::ray_tracing
