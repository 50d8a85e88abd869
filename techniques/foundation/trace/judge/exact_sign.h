// The side of a ray on which an edge passes: the sign of a determinant, computed exactly.
//
// After Shewchuk, "Adaptive Precision Floating-Point Arithmetic and Fast Robust Geometric Predicates", 1997: what double
// leaves undecided (ray_triangle.h) is computed again, first with twice its digits, and where that is not enough either (a ray
// aimed at a vertex, a mesh folded into one plane) with numbers kept as unevaluated sums of doubles.
// SPDX-License-Identifier: MIT
#pragma once
#include "techniques/foundation/math/types.h"

namespace shadowlab::trace {

/// Sign (-1, 0, 1) of direction . ((b - origin) x (c - origin)) for the doubles as they are given: positive when the
/// edge from b to c goes around the ray by the right hand. Exact as long as no product of three of the numbers leaves
/// the range 1e-250 .. 1e+300.
int exactTripleSign(const dvec3& direction, const dvec3& origin, const dvec3& b, const dvec3& c);

} // namespace shadowlab::trace
