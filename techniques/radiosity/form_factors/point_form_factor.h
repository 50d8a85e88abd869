// The form factor from a point to a polygon: the share of the light leaving a small flat piece of surface that reaches the
// polygon.
//
// J. H. Lambert, Photometria, 1760: the sum over the polygon's edges of the angle under which the edge is seen from the point,
// times the cosine between the normal at the point and the normal of the plane through edge and point. Exact for any size and
// distance.
// SPDX-License-Identifier: MIT
#pragma once
#include "techniques/radiosity/patches/polygon.h"

namespace shadowlab::radiosity {

/// Form factor from a piece at `position`, with that unit normal, to the front of a polygon with nothing in between: 0..1. The
/// polygon must lie before the plane of the piece (partBefore()), and the piece before the polygon's plane: parts behind count as
/// negative.
double pointFormFactor(const dvec3& position, const dvec3& normal, const Polygon& polygon);

} // namespace shadowlab::radiosity
