// How much do two polygons exchange with nothing in between?
//
// The inner integral, from a point to all of the other polygon, is Lambert's formula (point_form_factor.h); the outer one, over
// the points of the first, is quadrature by Gauss's points. Where the polygons touch, the integrand bends ever more sharply
// toward the ends of the common edge, and pieces are halved there until the sum stays as it is. Rectangles along common axes
// need neither (rectangle_exchange.h).
// SPDX-License-Identifier: MIT
#pragma once
#include "techniques/radiosity/patches/polygon.h"

namespace shadowlab::radiosity {

struct Exchange {
    double area = 0;  ///< A_1 F_12 = A_2 F_21, square metres
    double error = 0; ///< what halving the pieces once more still changed; of closed forms rounding only
};

/// Of the two front sides. What of either lies behind the other's plane exchanges nothing. The relative error is below
/// `tolerance`, as far as rounding allows: 1e-14 of the smaller polygon's area is noise.
Exchange unoccludedExchange(const Polygon& a, const Polygon& b, double tolerance = 1e-7);

/// The same by quadrature alone: to test the closed forms.
Exchange exchangeByQuadrature(const Polygon& a, const Polygon& b, double tolerance = 1e-7);

} // namespace shadowlab::radiosity
