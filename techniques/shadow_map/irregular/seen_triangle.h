// A triangle as the light sees it: three sides and a nearness, each a linear function of the places u and v of its picture
// plane. They hold, without clipping, also for a triangle that reaches behind the light: Olano and Greer, "Triangle Scan
// Conversion using 2D Homogeneous Coordinates", Graphics Hardware 1997.
//
// How large is their rounding error? Let M be the largest coordinate along the plane's axes, of the triangle and of the samples, s the
// longest part of an edge along one, and e = 2^-53. Turned into these axes, a corner is wrong by 12 e M and an edge by 12 e s;
// so a coefficient of a side, a sum of two products of corner and edge, by 110 e M s, the side at a place by 540 e M s. A
// sample's own place is wrong by 80 e (310 e M s), the sum of three terms is rounded (40 e M s), and the shadow ray that a
// SceneTracer sends has a rounded direction (20 e M s). kSideDouble is twice all that.
//
// The nearness of the plane is a quotient by the determinant. It knows more about it than a single ray does, whose sides are
// made of corners seen from the sample, not of edges: with R the lesser of M and the extent of the scene, the depth of a
// ray's hit is wrong by up to 105,000 e R^2 M, over the determinant. kNearnessDouble is a quarter more. A triangle whose
// determinant is not larger than that is *in doubt*: seen edge-on, or with the light in its plane, to within rounding. On
// which side of its edges a ray passes is certain even then (exact_sign.h), and where along itself it is hit is not.
// SPDX-License-Identifier: MIT
#pragma once
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>

#include "techniques/foundation/trace/ray_triangle.h"
#include "techniques/shadow_map/irregular/light_plane.h"

namespace shadowlab::shadow_map {

constexpr double kSideDouble = 0x1p-42, kNearnessDouble = 0x1p-36;

/// M and R as above.
struct Sizes {
    double m, r;
};

/// Is a determinant of that size beyond doubt?
inline bool isCertain(double determinant, const Sizes& sizes, bool parallel) {
    return 4 * kNearnessDouble * sizes.r * sizes.r * (parallel ? 1 : sizes.m) <= std::abs(determinant);
}

/// What the light sees of a triangle.
struct SeenTriangle {
    dvec3 sides[3];           ///< side(u, v) = x u + y v + z: positive inside, unless in doubt
    dvec3 nearness;           ///< likewise
    double nearest, farthest; ///< nearness that no corner exceeds, and none falls short of; infinite where it reaches
                              ///< behind the light, or nearly
    double largest, longest;  ///< its part in M; s
    double determinant;       ///< size of what the nearness was divided by
    std::uint32_t primitive;
    bool mayHaveHoles = false; ///< then a sample that is certainly behind it may still be lit

    [[nodiscard]] double sideBound(double m) const { return kSideDouble * m * longest; }
    /// Largest error of a nearness of at most `size`, of a triangle that is not in doubt.
    [[nodiscard]] double nearnessBound(const Sizes& sizes, double size, bool parallel) const {
        return kNearnessDouble * sizes.r * sizes.r / determinant * (parallel ? sizes.m + size : 1 + size * sizes.m);
    }
};

/// What bounds are made of, of all samples of a plane.
struct Asked {
    PlaneRect rect;
    double largest; ///< PlaceBox::largestCoordinate()
    double extent;  ///< of the scene: the largest difference of two coordinates
    [[nodiscard]] Sizes sizes(double largestOfTriangle) const {
        const double m = std::max(largest, largestOfTriangle);
        return {m, std::min(m, extent)};
    }
};

/// The triangle in the light's plane; its number, `primitive`, goes along.
SeenTriangle seenFrom(const LightPlane& plane, const trace::Triangle& triangle, std::uint32_t primitive,
                      const Asked& asked);

/// A rectangle of the plane in which are all samples that are asked and whose line through the light may meet the triangle
/// before the light; of a triangle in doubt, before or behind it. Nothing where there are none.
std::optional<PlaneRect> coveredRect(const LightPlane& plane, const trace::Triangle& triangle, const Asked& asked);

} // namespace shadowlab::shadow_map
