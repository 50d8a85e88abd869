// What share of what a small flat piece of surface sends out reaches a polygon?
//
// J. H. Lambert, Photometria, 1760: the sum over the polygon's edges of the angle under which an edge is seen, times the cosine
// between the piece's normal and the normal of the plane through the edge and the piece. Exact for any size and nearness.
// SPDX-License-Identifier: MIT
#pragma once
#include "techniques/radiosity/patches/polygon.h"

namespace shadowlab::radiosity {

/// Form factor from a piece at `position`, of that unit normal, to the front of a polygon with nothing in between: 0..1.
/// The polygon must lie before the plane of the piece (partBefore()), and the piece before the polygon's: what lies behind
/// counts as negative.
double pointFormFactor(const dvec3& position, const dvec3& normal, const Polygon& polygon);

} // namespace shadowlab::radiosity
