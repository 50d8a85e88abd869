// A ray prepared for box tests that miss no box it touches, so that the traversal of the tree is as watertight as the
// triangle test.
//
// The slab test of Kay and Kajiya (1986) in float. Three roundings could close a slab too early: the ray's origin is
// therefore rounded to both sides and each plane takes the side that is the safer one, and the way to the far planes is
// made longer by more than the arithmetic can be wrong (Ize, "Robust BVH Ray Traversal", JCGT 2(2), 2013). A ray that
// is parallel to a slab gives 0 * infinity, which is no number, where its origin lies on a plane: the comparisons are
// ordered so that it is dropped, and the sign of the direction is that of its reciprocal, so -0 is a direction of its
// own (Williams and others, "An Efficient and Robust Ray-Box Intersection Algorithm", 2005). The test itself, of eight boxes
// at once, is in bvh_kernel.h.
// SPDX-License-Identifier: MIT
#pragma once
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

#include "techniques/foundation/trace/bvh/bvh_walk.h"
#include "techniques/foundation/trace/ray_triangle.h"

namespace shadowlab::trace {

/// The float before and after a number (std::nextafter is a call into a library; this is made for every ray).
inline float justBelow(float f) {
    if (f == 0) return -std::numeric_limits<float>::denorm_min();
    const auto bits = std::bit_cast<std::uint32_t>(f);
    return std::bit_cast<float>(f > 0 ? bits - 1 : bits + 1);
}
inline float justAbove(float f) { return -justBelow(-f); }

inline float roundedDown(double x) {
    const float f = static_cast<float>(x);
    return static_cast<double>(f) > x ? justBelow(f) : f;
}
inline float roundedUp(double x) {
    const float f = static_cast<float>(x);
    return static_cast<double>(f) < x ? justAbove(f) : f;
}

// The preparation runs for every ray, so it has no unpredictable branch: a misprediction takes longer than the arithmetic.
// So numbers are not rounded up or down exactly, but moved by more than the rounding error.
constexpr float kTiniest = std::numeric_limits<float>::min();

/// A little more than the distance, in float: what is in double not beyond it is not beyond it in float either.
inline float reachInFloat(double reach) { return static_cast<float>(reach * (1 + 1e-6)) + kTiniest; }

// Entering and leaving a box are each wrong by up to four roundings of 2^-24: of plane less origin, of the inverse (of the
// larger one twice), and of their product. Ize's 1 + 2 gamma(n) is 1 + 4.8e-7 then.
constexpr double kLonger = 1 + 6e-7;

/// Puts the ray, from where it begins to where it ends, into a walk.
inline void aim(BvhWalk& walk, const Ray& ray, const ShearedRay& sheared) {
    for (int axis = 0; axis < 3; ++axis) {
        const double inverse = sheared.reachPerT / ray.directionCentred[axis];
        // 1 / -0 is -infinity: the sign bit counts. More than float holds is infinite: parallel.
        walk.nearSide[axis] = std::signbit(inverse) ? 1 : 0;
        walk.inverseEnter[axis] = static_cast<float>(inverse);
        walk.inverseLeave[axis] = static_cast<float>(inverse * kLonger);
        // To a plane ahead, less of the way is the safe side for entering, more of it for leaving.
        const auto origin = static_cast<float>(ray.originCentred[axis]);
        const float rounding = std::copysign(std::abs(origin) * 0x1p-23f + kTiniest, static_cast<float>(inverse));
        walk.originEnter[axis] = origin + rounding;
        walk.originLeave[axis] = origin - rounding;
    }
    walk.nearestBox = static_cast<float>(sheared.nearest * (1 - 1e-6));
    walk.farthestBox = reachInFloat(sheared.farthest);
    const int axes[3] = {sheared.kx, sheared.ky, sheared.kz};
    walk.largest = 0;
    for (int i = 0; i < 3; ++i) {
        walk.axes[i] = axes[i];
        walk.origin[i] = along(ray.originCentred, axes[i]);
        walk.largest = std::max(walk.largest, std::abs(walk.origin[i]));
    }
    walk.shearX = sheared.shearX;
    walk.shearY = sheared.shearY;
    walk.sign = sheared.sign;
    walk.nearest = sheared.nearest;
    walk.farthest = sheared.farthest;
}

} // namespace shadowlab::trace
