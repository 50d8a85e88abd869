// Under what solid angle does a point see a polygon? What a point light sends into it is that, times the light's intensity: of the
// irradiance I cos / d^2 every piece dA of the polygon gets I cos dA / d^2, and cos dA / d^2 is its solid angle.
// SPDX-License-Identifier: MIT
#pragma once
#include "techniques/radiosity/form_factors/polygon.h"

namespace shadowlab::radiosity {

/// Steradians; positive if the point lies before the polygon, negative behind it, 0 in its plane beside it. By triangles with a
/// common corner: A. van Oosterom and J. Strackee, "The Solid Angle of a Plane Triangle", IEEE Transactions on Biomedical
/// Engineering 30(2), 1983.
double solidAngle(const Polygon& polygon, const dvec3& point);

} // namespace shadowlab::radiosity
