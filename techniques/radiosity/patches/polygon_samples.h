// Evenly distributed sample points in polygons and pairs of polygons: the ends of lines that are tested for occlusion.
// SPDX-License-Identifier: MIT
#pragma once
#include <array>

#include "techniques/radiosity/patches/polygon.h"

namespace shadowlab::radiosity {

/// Point i of the `count` Hammersley points of the unit square of four dimensions, which fill it evenly only all together (J. M.
/// Hammersley, "Monte Carlo Methods for Solving Multivariable Problems", Annals of the New York Academy of Sciences 86, 1960).
/// The first two coordinates are the most even.
std::array<double, 4> hammersley4(int i, int count);

/// A point of a polygon and its weight, up to a factor of the polygon's: where the map from the unit square to the polygon does
/// not preserve area, as for quads that are not parallelograms, points stand for areas of different sizes.
struct Place {
    dvec3 point;
    double weight;
};

/// The image of the point (s, t) of the unit square in a polygon that is not empty.
Place placeIn(const Polygon& polygon, double s, double t);

/// The same such that all areas of the polygon have as many points, so that no weights are needed.
dvec3 evenPlaceIn(const Polygon& polygon, double s, double t);

} // namespace shadowlab::radiosity
