// Where triangles cut the surface of a sphere: the parts of circles that lie within them, as chords.
//
// A sphere sunk into a wall is seen as far as the circle in which the wall's plane cuts it. So these are contours like the edges of
// casters (area_visibility.h), though bent; seen from a point they are parts of ellipses.
// SPDX-License-Identifier: MIT
#pragma once
#include <vector>

#include "techniques/foundation/trace/bvh/bvh.h"

namespace shadowlab::trace {

/// One chord, and the triangle that cuts the sphere there.
struct SphereCut {
    std::uint32_t primitive = 0;
    dvec3 firstCentred{0.0}, secondCentred{0.0};
};

/// Adds the chords of one triangle; none where it does not cut the sphere. Simplified: 32 chords make a circle, moved outward so that together
/// they enclose its area. Each part of the circle is wrong by 0.3 % of its radius at most, now outward and now inward.
void addSphereCuts(const Triangle& triangle, std::uint32_t primitive, const dvec3& centreCentred, double radius, std::vector<SphereCut>& cuts);

} // namespace shadowlab::trace
