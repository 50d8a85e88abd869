// Under what solid angle does a point see a polygon? What a point light sends into it is that, times the light's intensity: of the
// irradiance I cos / d^2 every piece dA of the polygon gets I cos dA / d^2, and cos dA / d^2 is its solid angle.
//
// How much of a spot's light goes into a polygon: its solid angle as far as it lies within a cone with a smooth edge.
//
// A place on the sphere of directions is given by its angle theta from the cone's axis and its angle phi around it. The cone lets the
// share w(theta) through, so a figure around which phi runs once gets the integral over phi of
//     G(theta) = integral from 0 to theta of w(t) sin t dt,
// theta being its border's; and by Stokes's theorem every other figure gets the sum of that along its border. A side of a polygon is
// a part of a great circle, tan theta = tan delta / cos phi, with delta where it comes nearest to the axis, and phi from there.
// Where w = 1, G = 1 - cos theta, whose integral is phi - asin(cos delta sin phi); beyond the cone G stays as it is; the smooth edge
// between is integrated by Gauss's points.
// SPDX-License-Identifier: MIT
#pragma once
#include "techniques/radiosity/patches/polygon.h"

namespace shadowlab::radiosity {

/// Steradians; positive if the point lies before the polygon, negative behind it, 0 in its plane beside it. By triangles with a
/// common corner: A. van Oosterom and J. Strackee, "The Solid Angle of a Plane Triangle", IEEE Transactions on Biomedical
/// Engineering 30(2), 1983.
double solidAngle(const Polygon& polygon, const dvec3& point);

/// A cone of light, angles in radians.
struct LightCone {
    dvec3 apex{0.0}, axis{0.0, -1.0, 0.0}; ///< unit
    double half = 0;                       ///< from the axis to where no light is; below a right angle
    double edge = 0; ///< of it, the smooth band: the share rises inward from 0 to 1 as t^2 (3 - 2 t), 0 <= t <= 1
};

/// Steradians, those of the edge counted by their share. The apex must lie before the polygon. Right to rounding where
/// the cone has no smooth edge, else to 1e-7 of the whole cone.
double coneSolidAngle(const LightCone& cone, const Polygon& polygon);

} // namespace shadowlab::radiosity
