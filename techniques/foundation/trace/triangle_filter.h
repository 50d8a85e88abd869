// Four triangles at once, in float: which of them can the ray certainly not hit? What is left is asked again in double.
//
// The same sheared 2D test as in ray_triangle.h. All it needs besides is a bound for what float gets wrong, so that a
// triangle is thrown out only when two sides have certainly opposite signs.
// SPDX-License-Identifier: MIT
#pragma once
#include <algorithm>
#include <span>

#include "techniques/foundation/trace/float4.h"
#include "techniques/foundation/trace/ray_triangle.h"

namespace shadowlab::trace {

/// Up to four triangles, their coordinates side by side.
struct alignas(16) FourTriangles {
    float corners[3][3][4] = {}; ///< corner, axis, triangle
    std::uint32_t primitives[4] = {kNoPrimitive, kNoPrimitive, kNoPrimitive, kNoPrimitive};
    float largest = 0; ///< of all coordinates, without sign
    std::int32_t count = 0;

    void add(const Triangle& triangle, std::uint32_t primitive) {
        const dvec3* const points[3] = {&triangle.a, &triangle.b, &triangle.c};
        for (int corner = 0; corner < 3; ++corner)
            for (int axis = 0; axis < 3; ++axis) {
                corners[corner][axis][count] = static_cast<float>((*points[corner])[axis]);
                largest = std::max(largest, std::abs(corners[corner][axis][count]));
            }
        primitives[count++] = primitive;
    }
};

class FilterRay {
public:
    explicit FilterRay(const ShearedRay& ray)
        : kx_(ray.kx), ky_(ray.ky), kz_(ray.kz), shearX_(static_cast<float>(ray.shearX)),
          shearY_(static_cast<float>(ray.shearY)), originX_(static_cast<float>(ray.originCentred[ray.kx])),
          originY_(static_cast<float>(ray.originCentred[ray.ky])),
          originZ_(static_cast<float>(ray.originCentred[ray.kz])),
          largest_(std::max({std::abs(originX_), std::abs(originY_), std::abs(originZ_)})) {}

    /// One bit per triangle that the ray may hit.
    int candidates(const FourTriangles& four) const {
        Float4 x[3], y[3], most = Float4::all(0);
        for (int corner = 0; corner < 3; ++corner) {
            const Float4 z = Float4::load(four.corners[corner][kz_]) - Float4::all(originZ_);
            x[corner] = (Float4::load(four.corners[corner][kx_]) - Float4::all(originX_)) - Float4::all(shearX_) * z;
            y[corner] = (Float4::load(four.corners[corner][ky_]) - Float4::all(originY_)) - Float4::all(shearY_) * z;
            most = larger(magnitude(x[corner]), larger(magnitude(y[corner]), most));
        }
        const Float4 u = x[2] * y[1] - y[2] * x[1], v = x[0] * y[2] - y[0] * x[2], w = x[1] * y[0] - y[1] * x[0];
        // With M the largest coordinate and e = 2^-24, a sheared coordinate is wrong by at most d = 16 e M: the corner
        // and the origin are rounded, subtracted, the depth the same, sheared, and subtracted once more. A side, a
        // difference of two products of coordinates up to m, is then wrong by 4 d m + 2 d d for those and 4 e m m for
        // its own arithmetic. A quarter more makes up for rounding the bound itself.
        constexpr float kRounding = 1.0f / (1 << 24);
        constexpr float kUnderflow = 1e-37f; // products smaller than this lose digits, or are zero
        const float d = 20 * kRounding * std::max(largest_, four.largest);
        const Float4 bound =
            most * (Float4::all(4 * d) + Float4::all(5 * kRounding) * most) + Float4::all(3 * d * d + kUnderflow);
        const Float4 least = smaller(u, smaller(v, w)), greatest = larger(u, larger(v, w));
        const int rejected = whereLess(least, Float4::all(0) - bound) & whereLess(bound, greatest);
        return ~rejected & ((1 << four.count) - 1);
    }

private:
    int kx_, ky_, kz_;
    float shearX_, shearY_, originX_, originY_, originZ_, largest_;
};

} // namespace shadowlab::trace
