// The exchange area of two polygons with nothing in between.
//
// The inner integral, from a point to all of the other polygon, is Lambert's formula (point_form_factor.h). The outer one, over
// the points of the first polygon, is Gauss quadrature. Where the polygons touch, the integrand is not smooth at the ends of the
// common edge, and pieces are subdivided there until the sum converges: so many that polygons which are near go along their edges instead
// (outline_exchange.h). Axis-aligned rectangles have a closed form (rectangle_exchange.h).
// SPDX-License-Identifier: MIT
#pragma once
#include "techniques/radiosity/patches/polygon.h"

namespace shadowlab::radiosity {

struct Exchange {
    double area = 0;  ///< A_1 F_12 = A_2 F_21, square metres
    double error = 0; ///< the change by the last subdivision; for closed forms, rounding
};

/// For the two front sides. What lies behind the other polygon's plane exchanges nothing. The relative error is below
/// `tolerance`, as far as rounding allows: 1e-14 of the smaller polygon's area is noise.
Exchange unoccludedExchange(const Polygon& a, const Polygon& b, double tolerance = 1e-7);

/// The same by quadrature over the area alone, to test the others.
Exchange exchangeByQuadrature(const Polygon& a, const Polygon& b, double tolerance = 1e-7);

} // namespace shadowlab::radiosity
