// The exchange area of two rectangles in closed form.
//
// For rectangles whose edges are parallel to the same three axes, in parallel or perpendicular planes. The fourfold integral has
// a primitive, which is evaluated at all sixteen pairs of corners with alternating signs (J. R. Ehlert and T. F. Smith, "View
// Factors for Perpendicular and Parallel Rectangular Plates", Journal of Thermophysics and Heat Transfer 7(1), 1993). Walls,
// boxes and tables are all made of such rectangles.
// SPDX-License-Identifier: MIT
#pragma once
#include <optional>

#include "techniques/radiosity/patches/polygon.h"

namespace shadowlab::radiosity {

/// Exchange area A_1 F_12 = A_2 F_21 in square metres, of the two front sides, with nothing in between. Each must lie before the
/// other's plane. Nothing where they are not two such rectangles, or so far apart for their size that the sixteen terms would
/// cancel: there quadrature is accurate and quick.
std::optional<double> rectangleExchange(const Polygon& a, const Polygon& b);

} // namespace shadowlab::radiosity
