// Does a ray hit a triangle? Watertight: through the edge between two triangles, and through the vertex of a closed
// fan, no ray slips.
//
// Woop, Benthin and Wald, "Watertight Ray/Triangle Intersection", JCGT 2(1), 2013: shear space so that the ray becomes
// an axis, drop that axis, and ask on which side of each edge the origin of the plane lies. A vertex then is *one* 2D
// point whatever triangle it is asked for, and if the sides are decided without error, the 2D drawing of a mesh has no
// cracks. The paper works in float and repeats a zero in double. Here everything is double: a shadow ray that starts
// exactly on a surface wants the digits, and most triangles never come here, because a float filter (triangle_filter.h)
// has thrown them out. What float is to double there, an exact product is to double here: two rounded products that
// differ have the order of the true ones, since rounding is monotone; two that are equal are told apart by their
// rounding errors, which a fused multiply-add yields exactly.
// SPDX-License-Identifier: MIT
#pragma once
#include <cmath>
#include <optional>
#include <utility>

#include "techniques/foundation/trace/ray.h"

namespace shadowlab::trace {

struct Triangle {
    dvec3 a, b, c; ///< centred space; counter-clockwise seen from the front
};

/// A ray made ready for many triangles. Distances are counted along the axis in which the ray goes farthest ("reach"):
/// the length of the direction so is of no account, and equal for every triangle.
struct ShearedRay {
    explicit ShearedRay(const Ray& ray) : originCentred(ray.originCentred) {
        const dvec3 d = glm::abs(ray.directionCentred);
        kz = d.x > d.y ? (d.x > d.z ? 0 : 2) : (d.y > d.z ? 1 : 2);
        kx = (kz + 1) % 3;
        ky = (kx + 1) % 3;
        const double along = ray.directionCentred[kz];
        if (along < 0) std::swap(kx, ky); // keeps the winding
        shearX = ray.directionCentred[kx] / along;
        shearY = ray.directionCentred[ky] / along;
        sign = along < 0 ? -1.0 : 1.0;
        reachPerT = std::abs(along);
        nearest = ray.nearest * reachPerT;
        farthest = ray.farthest * reachPerT;
    }
    dvec3 originCentred;
    int kx, ky, kz;
    double shearX, shearY, sign, reachPerT;
    double nearest, farthest; ///< in units of reach
};

/// Sign-exact a.x * b.y - a.y * b.x: zero only if it is zero.
inline double side(const dvec2& a, const dvec2& b) {
    const double p = a.x * b.y, q = a.y * b.x;
    if (p != q) return p - q;
    return std::fma(a.x, b.y, -p) - std::fma(a.y, b.x, -q);
}

struct TriangleHit {
    double reach;
    dvec3 barycentric;
};

/// A hit beyond ray.nearest and not beyond `farthest`; at `farthest` itself the caller decides whom it belongs to.
/// Edges and vertices belong to all triangles that share them; edge-on triangles are not hit.
inline std::optional<TriangleHit> intersect(const ShearedRay& ray, const Triangle& triangle, double farthest) {
    const dvec3 a = triangle.a - ray.originCentred, b = triangle.b - ray.originCentred,
                c = triangle.c - ray.originCentred;
    const dvec2 a2(a[ray.kx] - ray.shearX * a[ray.kz], a[ray.ky] - ray.shearY * a[ray.kz]);
    const dvec2 b2(b[ray.kx] - ray.shearX * b[ray.kz], b[ray.ky] - ray.shearY * b[ray.kz]);
    const dvec2 c2(c[ray.kx] - ray.shearX * c[ray.kz], c[ray.ky] - ray.shearY * c[ray.kz]);
    const double u = side(c2, b2), v = side(a2, c2), w = side(b2, a2);
    if ((u < 0 || v < 0 || w < 0) && (u > 0 || v > 0 || w > 0)) return std::nullopt;
    const double sum = u + v + w;
    if (!(sum != 0)) return std::nullopt; // seen edge-on
    const double reach = ray.sign * (u * a[ray.kz] + v * b[ray.kz] + w * c[ray.kz]) / sum;
    if (!(reach > ray.nearest && reach <= farthest)) return std::nullopt; // false for NaN, too
    return TriangleHit{reach, dvec3(u, v, w) / sum};
}

} // namespace shadowlab::trace
