// The solid angle of a polygon, seen from a point: all of it, and the part within a cone of light with a smooth edge.
//
// A point light of intensity I sends I times the solid angle into a polygon: of the irradiance I cos / d^2 every piece dA of the
// polygon receives I cos dA / d^2, and cos dA / d^2 is its solid angle.
//
// For a spot, a direction is given by its angle theta from the cone's axis and its angle phi about it. The cone lets the share
// w(theta) through. A figure around the axis then has the integral over phi of
//     G(theta) = integral from 0 to theta of w(t) sin t dt,
// with theta that of its border; and by Stokes's theorem every other figure has the sum of that along its border. A side of a
// polygon is an arc of a great circle, tan theta = tan delta / cos phi, where delta is its smallest angle to the axis, and phi is
// counted from there. Where w = 1, G = 1 - cos theta, whose integral is phi - asin(cos delta sin phi); beyond the cone G is
// constant; the smooth edge between is integrated by Gauss quadrature.
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
    double half = 0;                       ///< from the axis to the end of the light; below a right angle
    double edge = 0; ///< the smooth band at its end: the share rises inward from 0 to 1 as t^2 (3 - 2 t), 0 <= t <= 1
};

/// Steradians, weighted by the share that the cone lets through. The apex must lie before the polygon. Exact to rounding where
/// the cone has no smooth edge, else to 1e-7 of the whole cone.
double coneSolidAngle(const LightCone& cone, const Polygon& polygon);

} // namespace shadowlab::radiosity
