// Points that lie evenly in a polygon, or in pairs of polygons: where lines that are tried begin and end.
// SPDX-License-Identifier: MIT
#pragma once
#include <array>

#include "techniques/radiosity/patches/polygon.h"

namespace shadowlab::radiosity {

/// The i-th of `count` points that lie still more evenly, but only all together: J. M. Hammersley, "Monte Carlo Methods for Solving
/// Multivariable Problems", Annals of the New York Academy of Sciences 86, 1960. Most evenly in the first two coordinates.
std::array<double, 4> hammersley4(int i, int count);

/// A point of a polygon, and by how much larger its surroundings are than those of others, up to a factor of the polygon's: evenly
/// in the square is not evenly in a quad that is no parallelogram.
struct Place {
    dvec3 point;
    double weight;
};

/// Where a point (s, t) of the unit square lies in a polygon that is not empty.
Place placeIn(const Polygon& polygon, double s, double t);

} // namespace shadowlab::radiosity
