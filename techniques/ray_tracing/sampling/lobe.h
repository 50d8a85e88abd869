// Random directions of a lobe around an axis: the reflection or refraction of a rough surface.
//
// The density is a power of the cosine of the angle to the axis, as in Phong's highlight (1975); the power is given by the angle
// at which half of the maximum is left. At 60 degrees the power is 1, Lambert's law about that axis. R. L. Cook, T. Porter and L.
// Carpenter, "Distributed Ray Tracing", SIGGRAPH 1984.
// SPDX-License-Identifier: MIT
#pragma once
#include "techniques/foundation/math/types.h"

namespace shadowlab::ray_tracing {

/// The power n with cos(halfDegrees)^n = 1/2, for angles above 0. At 90 degrees it is 0: all directions of the half-space are
/// equally likely.
double lobePower(double halfDegrees);

/// The direction for two numbers in [0, 1), with the density (n + 1) / (2 pi) cos^n. Unit vectors.
dvec3 lobeDirection(const dvec3& axis, double power, dvec2 numbers);

/// Maps the unit square to the unit disc, preserving areas and neighbourhoods. P. Shirley and K. Chiu, "A Low Distortion Map
/// Between Disk and Square", Journal of Graphics Tools 1997.
dvec2 onDisc(dvec2 numbers);

} // namespace shadowlab::ray_tracing
