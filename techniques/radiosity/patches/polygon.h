// Flat convex polygons: the shape of patches, and of parts of them cut by planes.
// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <initializer_list>
#include <span>

#include "techniques/foundation/math/types.h"
#include "techniques/foundation/trace/area/shaft.h"

namespace shadowlab::radiosity {

/// Corners in one plane, counter-clockwise seen from the front; in centred or world space, the same for all that are used
/// together.
class Polygon {
public:
    /// Enough for quads cut by two planes and a few edges.
    static constexpr std::size_t kMostCorners = 16;

    Polygon() = default;
    Polygon(std::initializer_list<dvec3> corners) {
        for (const dvec3& corner : corners)
            add(corner);
    }
    /// Beyond kMostCorners a corner is left out.
    void add(const dvec3& corner) {
        if (count_ < kMostCorners) corners_[count_++] = corner;
    }
    [[nodiscard]] std::span<const dvec3> corners() const { return {corners_.data(), count_}; }
    [[nodiscard]] std::size_t count() const { return count_; }
    [[nodiscard]] const dvec3& operator[](std::size_t i) const { return corners_[i]; }
    /// Fewer than three corners: the empty polygon.
    [[nodiscard]] bool isEmpty() const { return count_ < 3; }

private:
    std::array<dvec3, kMostCorners> corners_{};
    std::size_t count_ = 0;
};

/// Area times the unit normal of the front side.
dvec3 areaVector(const Polygon& polygon);
/// Has it fewer than three corners, or do they lie in one line? This happens to pieces smaller than the rounding of positions.
/// Such a piece neither receives nor sends light.
bool hasNoArea(const Polygon& polygon);
/// The centroid of the area, not the mean of the corners.
dvec3 centroid(const Polygon& polygon);

/// All points p with dot(normal, p - point) = 0; the front is where that is positive.
struct Plane {
    dvec3 point{0.0}, normal{0.0}; ///< unit
    [[nodiscard]] double height(const dvec3& p) const { return glm::dot(normal, p - point); }
};
Plane planeOf(const Polygon& polygon);

/// Coordinates in the plane of a face.
struct FaceFrame {
    dvec3 originCentred{0.0}, u{0.0}, v{0.0}; ///< u and v are unit
    [[nodiscard]] dvec2 place(const dvec3& pointCentred) const {
        return {glm::dot(u, pointCentred - originCentred), glm::dot(v, pointCentred - originCentred)};
    }
};
/// u is parallel to its first edge. Seen from the front, u and v are right-handed.
FaceFrame frameOf(const Polygon& polygon);

/// The contact tolerance: what is nearer than this share of the size of the things compared touches, or lies in a plane. Vertices
/// are floats: a box that stands on a floor is some 2^-24 of its size above it or below.
constexpr double kTouching = 2e-7;

/// Is the point within the convex polygon, or straight above or below it? `normal`: of its front.
bool holds(const Polygon& polygon, const dvec3& point, const dvec3& normal);

trace::CentredBox boxOf(const Polygon& polygon);
/// Around both.
trace::CentredBox around(trace::CentredBox box, const trace::CentredBox& other);
/// 0 where they touch.
double distanceBetween(const trace::CentredBox& a, const trace::CentredBox& b);
/// The diagonal of the polygon's box, metres.
double sizeOf(const Polygon& polygon);
/// Is no corner more than `tolerance` metres before the plane?
bool isBehind(const Plane& plane, const Polygon& polygon, double tolerance);

/// The part of a polygon before a plane (I. Sutherland and G. Hodgman, 1974). A corner within `tolerance` metres of the plane
/// counts as in it, so that polygons that touch along an edge do not cut slivers off each other.
Polygon partBefore(const Plane& plane, const Polygon& polygon, double tolerance);

/// The part of a polygon that lies straight above or below another, convex one with that normal of its front. `tolerance`: of each of its sides, as there.
Polygon partWithin(const Polygon& outline, const dvec3& normal, Polygon part, double tolerance);

/// The area of the part of a polygon that lies within a circle in its plane.
double areaWithinCircle(const Polygon& polygon, const dvec3& middle, double radius);

} // namespace shadowlab::radiosity
