// Which of four boxes may a ray touch? Conservative: a touched box is never left out, so what is watertight among the
// triangles stays so through the tree.
//
// The slab test of Kay and Kajiya (1986) in float. Three roundings could close a slab too early: the ray's origin is
// therefore rounded to both sides and each plane takes the side that is the safer one, and the way to the far planes is
// made longer by more than the arithmetic can be wrong (Ize, "Robust BVH Ray Traversal", JCGT 2(2), 2013). A ray that
// is parallel to a slab gives 0 * infinity, which is no number, where its origin lies on a plane: the comparisons are
// ordered so that it is dropped, and the sign of the direction is that of its reciprocal, so -0 is a direction of its
// own (Williams and others, "An Efficient and Robust Ray-Box Intersection Algorithm", 2005).
// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

#include "techniques/foundation/trace/float4.h"
#include "techniques/foundation/trace/ray_triangle.h"

namespace shadowlab::trace {

/// Four boxes side by side: planes[axis][0] their lower, planes[axis][1] their upper planes. Rounded outward.
struct alignas(16) FourBoxes {
    float planes[3][2][4];
};

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

/// A ray made ready for many boxes. Distances are in units of reach, as in ShearedRay.
class SlabRay {
public:
    explicit SlabRay(const Ray& ray, const ShearedRay& sheared) {
        for (int axis = 0; axis < 3; ++axis) {
            const double inverse = sheared.reachPerT / ray.directionCentred[axis];
            // 1 / -0 is -infinity: the sign bit counts. More than float holds is infinite: parallel.
            nearSide_[axis] = std::signbit(inverse) ? 1 : 0;
            inverse_[axis] = static_cast<float>(inverse);
            // To a plane ahead, less of the way is the safe side for entering, more of it for leaving.
            const float low = roundedDown(ray.originCentred[axis]), high = roundedUp(ray.originCentred[axis]);
            originEnter_[axis] = nearSide_[axis] ? low : high;
            originLeave_[axis] = nearSide_[axis] ? high : low;
        }
        nearest_ = roundedDown(sheared.nearest * (1 - kSlack));
    }

    /// One bit per box that may be touched before `farthest`; `enter` receives where each is entered.
    int touched(const FourBoxes& boxes, float farthest, Float4& enter) const {
        enter = Float4::all(nearest_);
        Float4 leave = Float4::all(farthest);
        for (int axis = 0; axis < 3; ++axis) {
            const Float4 inverse = Float4::all(inverse_[axis]);
            const Float4 in =
                (Float4::load(boxes.planes[axis][nearSide_[axis]]) - Float4::all(originEnter_[axis])) * inverse;
            const Float4 out =
                (Float4::load(boxes.planes[axis][1 - nearSide_[axis]]) - Float4::all(originLeave_[axis])) * inverse;
            enter = larger(in, enter);
            leave = smaller(out * Float4::all(1 + kSlack), leave);
        }
        return whereAtMost(enter, leave);
    }

private:
    // Entering and leaving are each wrong by three roundings of 2^-24; Ize's 1 + 2 gamma(3) is 1 + 3.6e-7, one more
    // rounding comes from this multiplication itself.
    static constexpr float kSlack = 5e-7f;
    std::array<float, 3> inverse_{}, originEnter_{}, originLeave_{};
    std::array<int, 3> nearSide_{};
    float nearest_;
};

} // namespace shadowlab::trace
