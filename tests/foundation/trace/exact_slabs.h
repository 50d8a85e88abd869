// The slab test of a ray against a cube in small integers, which is exact: box tests with rounding are compared with it.
// SPDX-License-Identifier: MIT
#pragma once
#include <algorithm>
#include <limits>

#include "techniques/foundation/trace/ray.h"

namespace shadowlab::testing {

/// The slabs without a division: where a direction has no part along an axis, the origin must lie between the planes.
inline bool touchesExactly(const trace::Ray& ray, double lower, double upper) {
    double enter = 0, leave = std::numeric_limits<double>::infinity();
    for (int axis = 0; axis < 3; ++axis) {
        const double o = ray.originCentred[axis], d = ray.directionCentred[axis];
        if (d == 0) {
            if (o < lower || o > upper) return false;
            continue;
        }
        enter = std::max(enter, std::min((lower - o) / d, (upper - o) / d)); // small integers: exact
        leave = std::min(leave, std::max((lower - o) / d, (upper - o) / d));
    }
    return enter <= leave;
}

} // namespace shadowlab::testing
