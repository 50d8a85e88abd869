// Flat convex polygons: what patches are, and what is left of one when another's plane cuts it.
// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <initializer_list>
#include <span>

#include "techniques/foundation/math/types.h"
#include "techniques/foundation/trace/area/shaft.h"

namespace shadowlab::radiosity {

/// Corners in one plane, counter-clockwise seen from the front; in centred or world space, as long as all that are put
/// together share it.
class Polygon {
public:
    /// Quads that two planes and a few edges have cut.
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
    /// Fewer corners than a triangle has: nothing.
    [[nodiscard]] bool isEmpty() const { return count_ < 3; }

private:
    std::array<dvec3, kMostCorners> corners_{};
    std::size_t count_ = 0;
};

/// Area times the unit normal of the front side.
dvec3 areaVector(const Polygon& polygon);
/// Has it fewer corners than a triangle, or do they lie in one line, as those of pieces do that are smaller than what rounding leaves of
/// positions? Such a piece gets no light and sends none.
bool hasNoArea(const Polygon& polygon);
/// Of its area, not of its corners.
dvec3 centroid(const Polygon& polygon);

/// All points p with dot(normal, p - point) = 0; the front is where that is positive.
struct Plane {
    dvec3 point{0.0}, normal{0.0}; ///< unit
    [[nodiscard]] double height(const dvec3& p) const { return glm::dot(normal, p - point); }
};
Plane planeOf(const Polygon& polygon);

/// What is nearer than this share of the size of the things in question touches, or lies in a plane: vertices are floats, and a box
/// that stands on a floor is some 2^-24 of its size above it or below.
constexpr double kTouching = 2e-7;

trace::CentredBox boxOf(const Polygon& polygon);
/// Diagonal of that box, metres.
double sizeOf(const Polygon& polygon);
/// Is no corner more than `tolerance` metres before the plane?
bool isBehind(const Plane& plane, const Polygon& polygon, double tolerance);

/// What of a polygon lies before a plane (Sutherland and Hodgman, 1974). A corner within `tolerance` metres of the plane lies
/// in it: polygons that touch along an edge do not cut slivers off each other.
Polygon partBefore(const Plane& plane, const Polygon& polygon, double tolerance);

} // namespace shadowlab::radiosity
