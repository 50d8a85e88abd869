// The winding number of closed surfaces around a place: how often they enclose it.
//
// On the way to far away a body is left as often as it is entered, if one begins outside. So count 1 where a surface is met from
// behind, on the way out, and -1 where it is met from the front, on the way in: the sum is 0 outside of everything.
// SPDX-License-Identifier: MIT
#pragma once
#include "techniques/foundation/trace/bvh/bvh.h"

namespace shadowlab::radiosity {

/// What one triangle that a ray meets adds to the winding number of the place that the ray begins at.
inline int windingOf(const trace::Triangle& triangle, const dvec3& direction) {
    return glm::dot(glm::cross(triangle.b - triangle.a, triangle.c - triangle.a), direction) > 0 ? 1 : -1;
}

} // namespace shadowlab::radiosity
