// The intersection of a ray and a triangle. Watertight: no ray passes between two triangles at their common edge, or
// through the vertex of a closed fan.
//
// Woop, Benthin and Wald, "Watertight Ray/Triangle Intersection", JCGT 2(1), 2013: shear space so that the ray becomes
// an axis, drop that axis, and ask on which side of each edge the origin of the plane lies. The paper works in float,
// where the two triangles of an edge compute the very same number, and repeats a zero in double. Here everything is
// double: a shadow ray that starts exactly on a surface wants the digits, and of most triangles a tree finds out by the same
// test, four at a time, that they are missed (bvh_kernel.h). Where rounding leaves double undecided, the sign is computed
// exactly, from the coordinates as they were given (exact_sign.h). So it is the sign of the real ray and the real edge,
// not only one that all triangles agree on.
// SPDX-License-Identifier: MIT
#pragma once
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include <glm/gtc/type_ptr.hpp>

#include "techniques/foundation/trace/judge/exact_sign.h"
#include "techniques/foundation/trace/ray.h"

namespace shadowlab::trace {

struct Triangle {
    dvec3 a, b, c; ///< centred space; counter-clockwise seen from the front
};

/// A coordinate by its number. (GLM's operator[] is a switch, a branch that is often mispredicted.)
inline double along(const dvec3& v, int axis) { return glm::value_ptr(v)[axis]; }
/// Without signs. (GLM's version branches on each sign, likewise.)
inline dvec3 magnitudes(const dvec3& v) { return {std::abs(v.x), std::abs(v.y), std::abs(v.z)}; }

/// A ray made ready for many triangles. Distances are counted along the axis in which the ray goes farthest ("reach"):
/// the length of the direction so is of no account, and equal for every triangle.
struct ShearedRay {
    explicit ShearedRay(const Ray& ray) : originCentred(ray.originCentred), directionCentred(ray.directionCentred) {
        const dvec3 d = magnitudes(ray.directionCentred);
        // As arithmetic, since a branch on the axis would be mispredicted.
        const bool xOverY = d.x > d.y, xOverZ = d.x > d.z, yOverZ = d.y > d.z;
        kz = 2 - 2 * int(xOverY & xOverZ) - int(!xOverY & yOverZ);
        const double depth = along(ray.directionCentred, kz);
        const int turned = depth < 0; // x and y change places, which keeps the winding
        kx = (kz + 1 + turned) % 3;
        ky = (kz + 2 - turned) % 3;
        shearX = along(ray.directionCentred, kx) / depth;
        shearY = along(ray.directionCentred, ky) / depth;
        sign = depth < 0 ? -1.0 : 1.0;
        reachPerT = std::abs(depth);
        nearest = ray.nearest * reachPerT;
        farthest = ray.farthest * reachPerT;
    }
    dvec3 originCentred, directionCentred;
    int kx, ky, kz;
    double shearX, shearY, sign, reachPerT;
    double nearest, farthest; ///< in units of reach
};

/// Twice the area spanned by two sheared corners: positive when the origin is to the left of the way from a to b.
inline double side(const dvec2& a, const dvec2& b) { return a.x * b.y - a.y * b.x; }

/// The same for the corners b and c as they are given, its sign beyond doubt: `value` is kept where it is farther from
/// zero than `bound`. Otherwise it gets the right sign; how small it is then does not matter.
inline double certainSide(double value, double bound, const ShearedRay& ray, const dvec3& b, const dvec3& c) {
    if (std::abs(value) > bound) return value;
    const int sign = exactTripleSign(ray.directionCentred, ray.originCentred, b, c);
    return sign == 0 ? 0.0 : std::copysign(std::max(std::abs(value), std::numeric_limits<double>::min()), sign);
}

/// Largest error of side(). With M the largest coordinate of the corners as seen from the ray's origin and e = 2^-53: a
/// corner is subtracted (e M), its depth sheared (3 e M, the shear being at most 1) and taken off (e 2 M), so a sheared
/// coordinate, at most 2 M, is wrong by 6 e M. A product of two is wrong by 2 * 2 M * 6 e M and, rounded, e 4 M^2 more;
/// the difference of two such by 56 e M^2 + e 8 M^2. Six more make up for the squares of e and for rounding this bound.
inline double sideBound(double largest) { return 70 * 0x1p-53 * largest * largest; }

struct TriangleHit {
    double reach;
    dvec3 barycentric;
};

/// A hit beyond ray.nearest and not beyond `farthest`; at `farthest` itself the caller decides which hit counts. Edges and
/// vertices belong to all triangles that share them; edge-on triangles are not hit.
inline std::optional<TriangleHit> intersect(const ShearedRay& ray, const Triangle& triangle, double farthest) {
    const dvec3 a = triangle.a - ray.originCentred, b = triangle.b - ray.originCentred,
                c = triangle.c - ray.originCentred;
    const auto flat = [&ray](const dvec3& p) {
        const double z = along(p, ray.kz);
        return dvec2(along(p, ray.kx) - ray.shearX * z, along(p, ray.ky) - ray.shearY * z);
    };
    const dvec2 a2 = flat(a);
    const dvec2 b2 = flat(b);
    const dvec2 c2 = flat(c);
    double u = side(c2, b2), v = side(a2, c2), w = side(b2, a2);
    const dvec3 most = glm::max(magnitudes(a), glm::max(magnitudes(b), magnitudes(c)));
    const double bound = sideBound(std::max(most.x, std::max(most.y, most.z)));
    if (std::min(u, std::min(v, w)) < -bound && std::max(u, std::max(v, w)) > bound) return std::nullopt;
    u = certainSide(u, bound, ray, triangle.c, triangle.b);
    v = certainSide(v, bound, ray, triangle.a, triangle.c);
    w = certainSide(w, bound, ray, triangle.b, triangle.a);
    if ((u < 0 || v < 0 || w < 0) && (u > 0 || v > 0 || w > 0)) return std::nullopt;
    const double sum = u + v + w;
    if (!(sum != 0)) return std::nullopt; // seen edge-on
    const double reach = ray.sign * (u * along(a, ray.kz) + v * along(b, ray.kz) + w * along(c, ray.kz)) / sum;
    if (!(reach > ray.nearest && reach <= farthest)) return std::nullopt; // false for NaN, too
    return TriangleHit{reach, dvec3(u, v, w) / sum};
}

} // namespace shadowlab::trace
