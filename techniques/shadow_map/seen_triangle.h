// A triangle as the light sees it: three sides and a nearness, each a linear function of the places u and v of its picture
// plane. They hold, without clipping, also for a triangle that reaches behind the light: Olano and Greer, "Triangle Scan
// Conversion using 2D Homogeneous Coordinates", Graphics Hardware 1997.
//
// How wrong are they? Let M be the largest coordinate along the plane's axes, of the triangle and of who is asked, s the
// longest part of an edge along one, and e = 2^-53. Turned into these axes, a corner is wrong by 12 e M and an edge by 12 e s;
// so a coefficient of a side, a sum of two products of corner and edge, by 110 e M s, the side at a place by 540 e M s. A
// sample's own place is wrong by 80 e (310 e M s), the sum of three terms is rounded (40 e M s), and the shadow ray that a
// SceneTracer sends has a rounded direction (20 e M s). kSideDouble is twice all that. The nearness of the plane is a quotient
// by the determinant; beside what it gets wrong, a hit on the single ray is known to 105,000 e M^3 over the determinant
// only, whose sides are computed from the corners, not the edges. kNearnessDouble is a quarter more than that.
// SPDX-License-Identifier: MIT
#pragma once
#include <cmath>
#include <cstdint>
#include <optional>

#include "techniques/foundation/trace/ray_triangle.h"
#include "techniques/shadow_map/light_plane.h"

namespace shadowlab::shadow_map {

constexpr double kSideDouble = 0x1p-42, kNearnessDouble = 0x1p-36;

/// Can a determinant of that size, or its sign, be relied on? M is meant as above.
inline bool isCertain(double determinant, double m, bool parallel) {
    return 4 * kNearnessDouble * m * m * (parallel ? 1 : m) <= std::abs(determinant);
}

struct SeenTriangle {
    dvec3 sides[3];           ///< side(u, v) = x u + y v + z: positive inside, unless the determinant is in doubt
    dvec3 nearness;           ///< likewise
    double nearest, farthest; ///< nearness that no corner exceeds, and none falls short of; infinite where it reaches
                              ///< behind the light, or nearly
    double largest, longest;
    double determinant; ///< size of what the nearness was divided by
    std::uint32_t primitive;

    [[nodiscard]] double sideBound(double m) const { return kSideDouble * m * longest; }
    /// Largest error of a nearness of at most `size`, where the determinant is certain.
    [[nodiscard]] double nearnessBound(double m, double size, bool parallel) const {
        return kNearnessDouble * m * m / determinant * (parallel ? m + size : 1 + size * m);
    }
};

/// `largest` is the largest coordinate, along the plane's axes, of all samples.
SeenTriangle seenFrom(const LightPlane& plane, const trace::Triangle& triangle, std::uint32_t primitive,
                      double largest);

/// A rectangle of the plane outside which no sample of `asked` is covered by the triangle; nothing where none is at all. Of a
/// triangle that reaches behind the light, and seems to have it in its plane, it is all that is asked.
std::optional<PlaneRect> coveredRect(const LightPlane& plane, const trace::Triangle& triangle, const PlaneRect& asked,
                                     double largest);

} // namespace shadowlab::shadow_map
