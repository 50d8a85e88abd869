// Where triangles cut the surface of a sphere: the parts of circles that lie within them, as chords.
//
// A sphere sunk into a wall is seen as far as the circle in which the wall's plane cuts it. So these are contours like the edges of
// casters (area_visibility.h), though bent; seen from a point they are parts of ellipses. Mostly they go around all that is seen, which is then
// clipped to them; so one ray is enough, where contours would part the light into as many pieces.
// SPDX-License-Identifier: MIT
#pragma once
#include <span>
#include <vector>

#include "techniques/foundation/trace/bvh/bvh.h"

namespace shadowlab::trace {

/// Where a plane cuts a sphere: middle + radius * (cos * u + sin * v).
struct CutCircle {
    CutCircle(const dvec3& normal, double level, const dvec3& centreCentred, double sphereRadius);
    [[nodiscard]] double height(const dvec3& placeCentred) const { return glm::dot(normal, placeCentred) - level; }
    [[nodiscard]] dvec3 place(double angle, double stretch = 1) const {
        return middle + stretch * radius * (glm::cos(angle) * u + glm::sin(angle) * v);
    }
    dvec3 normal; ///< of the plane, unit
    double level; ///< products of the plane's places with it
    dvec3 u, v, middle;
    double radius;
};

/// One chord, and the triangle that cuts the sphere there. It runs counter-clockwise around the normal of its circle, from one angle to another.
struct SphereCut {
    std::uint32_t primitive = 0, circle = 0;
    double begin = 0, end = 0;
    dvec3 firstCentred{0.0}, secondCentred{0.0};
};

class SphereCuts {
public:
    SphereCuts() = default;
    SphereCuts(const dvec3& centreCentred, double radius) : centreCentred_(centreCentred), radius_(radius) {}
    /// Adds the chords of one triangle; none where it does not cut the sphere. Simplified: 32 chords make a circle, moved outward so that
    /// together they enclose its area. Each part of the circle is wrong by 0.3 % of its radius at most, now outward and now inward.
    void add(const Triangle& triangle, std::uint32_t primitive);
    [[nodiscard]] std::span<const SphereCut> chords() const { return chords_; }

    /// From before the planes of some chords, as from within a room that a lamp's ball reaches out of, one sees the part of the ball that is
    /// before them, too. That part is convex, and if each of these chords is before all of those planes, they are what bounds it, together
    /// with the border of the disc. False where that is not so, or not certain.
    [[nodiscard]] bool boundOneConvexPart(std::span<const std::uint32_t> chords, const dvec3& positionCentred) const;
    /// Then the normal toward that part, of the plane through the point and a chord; zero where the chord bounds nothing. Of a circle that
    /// goes on behind the ball, the last chord ends where the border of the disc is.
    [[nodiscard]] dvec3 inward(std::uint32_t chord, const dvec3& positionCentred) const;

private:
    /// Bits: circles all of whose chords are before the plane of a circle, and behind it.
    struct Sides {
        std::uint64_t before = ~std::uint64_t{0}, behind = before;
    };
    [[nodiscard]] std::uint32_t numberOf(const CutCircle& circle) const;
    void addCircle(const CutCircle& circle);
    void compare(std::uint32_t circle, const SphereCut& chord);

    dvec3 centreCentred_{0.0};
    double radius_ = 0;
    std::vector<SphereCut> chords_;
    std::vector<CutCircle> circles_;
    std::vector<Sides> sides_; ///< of the first circles
};

} // namespace shadowlab::trace
