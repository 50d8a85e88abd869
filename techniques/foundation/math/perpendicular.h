// A direction at right angles to another one.
// SPDX-License-Identifier: MIT
#pragma once
#include "techniques/foundation/math/types.h"

namespace shadowlab {

/// A unit vector perpendicular to a unit vector: its cross product with the axis of its smallest component, to which it is never
/// parallel.
inline dvec3 perpendicularTo(const dvec3& unit) {
    const dvec3 size = glm::abs(unit);
    const int least = size.x < size.y ? (size.x < size.z ? 0 : 2) : (size.y < size.z ? 1 : 2);
    dvec3 axis(0.0);
    axis[least] = 1;
    return glm::normalize(glm::cross(unit, axis));
}

} // namespace shadowlab
