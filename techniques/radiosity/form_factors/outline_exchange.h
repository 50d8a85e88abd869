// The exchange area of two polygons with nothing in between, along their edges alone.
//
// By Stokes' theorem, applied to both polygons, A_1 F_12 is the integral of ln r, r being the distance of two points, over all pairs of
// places on the two outlines (E. Sparrow, A New and Simpler Formulation for Radiative Angle Factors, Journal of Heat Transfer 85, 1963):
//
//     A_1 F_12 = 1 / (2 pi)  sum over edges i of 1, j of 2:  (u_i . u_j)  integral ds  integral dt  ln r(s, t)
//
// with unit vectors u along the edges. The inner integral has a closed form, the outer one is Gauss quadrature. Near an edge that
// both share ln r has a pole, but only its ends and the ends of its neighbours need short pieces; quadrature over the polygon's area
// (polygon_exchange.h) needs them all along the edge.
// SPDX-License-Identifier: MIT
#pragma once
#include <optional>

#include "techniques/radiosity/form_factors/polygon_exchange.h"

namespace shadowlab::radiosity {

/// For polygons that lie before each other's planes. The relative error is below `tolerance`. Nothing where rounding would be more: the
/// terms are as large as the product of two edges, and cancel where little is exchanged.
std::optional<Exchange> exchangeByOutlines(const Polygon& a, const Polygon& b, double tolerance);

} // namespace shadowlab::radiosity
