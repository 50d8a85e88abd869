// Tests of a ray against a box and a ball. Conservative, in double: a volume that the ray touches is never missed.
//
// Box: the slabs of Kay and Kajiya (1986). The way to a plane, (plane - origin) * (1 / direction), has three roundings and
// so is wrong by less than gamma(3) = 3e / (1 - 3e) of itself, e = 2^-53; the way out is made longer by twice that, for
// it and for the way in (Ize, "Robust BVH Ray Traversal", JCGT 2(2), 2013). A ray parallel to a slab gives infinities of
// the right signs, and 0 * infinity, which is no number, where it runs in a plane: the comparisons are ordered so that it
// is dropped (Williams and others, "An Efficient and Robust Ray-Box Intersection Algorithm", 2005). The planes are the
// coordinates of corners, exactly.
//
// Ball: how far from the line is the centre? The schoolbook's discriminant b^2 - ac subtracts the squares of two distances
// to find a radius: far away nothing is left of it. Here the vector from the centre to the line's nearest point is made
// first, and that is as long as the radius, not as the distance (Haines, Günther and Akenine-Möller, "Precision
// Improvements for Ray/Sphere Intersection", Ray Tracing Gems ch. 7, 2019). With f the vector from centre to origin, it is
// wrong by less than 16 e |f|: f itself and the direction, made one long in reach, by one rounding each, the share of the
// direction by eight, its product and the sum by two, and the rest is for products of errors. The radius is made larger by
// twice that, counting the radius to |f| for the squares and the root, which are rounded too.
// SPDX-License-Identifier: MIT
#pragma once
#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

#include "techniques/foundation/trace/ray_triangle.h"

namespace shadowlab::trace {

constexpr double kNowhere = std::numeric_limits<double>::infinity(); ///< where a ray enters what it does not touch

struct Box {
    dvec3 lowerCentred{kNowhere}, upperCentred{-kNowhere};
    void include(const dvec3& p) {
        lowerCentred = glm::min(lowerCentred, p);
        upperCentred = glm::max(upperCentred, p);
    }
    void include(const Triangle& t) {
        include(t.a);
        include(t.b);
        include(t.c);
    }
    void include(const Box& other) {
        lowerCentred = glm::min(lowerCentred, other.lowerCentred);
        upperCentred = glm::max(upperCentred, other.upperCentred);
    }
    [[nodiscard]] bool isEmpty() const { return !(lowerCentred.x <= upperCentred.x); }
    [[nodiscard]] dvec3 centre() const { return 0.5 * lowerCentred + 0.5 * upperCentred; }
};

struct Ball {
    dvec3 centreCentred{0.0};
    double radius = -1; ///< negative: empty
};

/// A ray made ready for many volumes. Distances are in units of reach, as in ShearedRay.
class VolumeRay {
public:
    explicit VolumeRay(const ShearedRay& ray)
        : origin_(ray.originCentred), direction_(ray.directionCentred / ray.reachPerT),
          inverse_(ray.reachPerT / ray.directionCentred), inverseSquare_(1 / glm::dot(direction_, direction_)),
          nearest_(ray.nearest) {}

    /// Where the ray enters the box, if that is before `farthest`; not before where the ray begins. Else kNowhere.
    [[nodiscard]] double enter(const Box& box, double farthest) const {
        double enter = nearest_ * (1 - 2 * kGamma3), leave = farthest;
        for (int axis = 0; axis < 3; ++axis) {
            // The sign of the reciprocal tells the near plane: -0 is a direction of its own.
            const bool backward = std::signbit(inverse_[axis]);
            const double nearPlane = backward ? box.upperCentred[axis] : box.lowerCentred[axis];
            const double farPlane = backward ? box.lowerCentred[axis] : box.upperCentred[axis];
            const double in = (nearPlane - origin_[axis]) * inverse_[axis];
            const double out = (farPlane - origin_[axis]) * inverse_[axis] * (1 + 2 * kGamma3);
            enter = in > enter ? in : enter; // no number is never larger, nor smaller
            leave = out < leave ? out : leave;
        }
        return enter <= leave ? enter : kNowhere;
    }

    [[nodiscard]] double enter(const Ball& ball, double farthest) const {
        const dvec3 fromCentre = origin_ - ball.centreCentred;
        const double slack = 32 * 0x1p-53 * (glm::length(fromCentre) + ball.radius);
        // Where the line passes the centre, and the vector to there.
        const double pass = -glm::dot(fromCentre, direction_) * inverseSquare_;
        const dvec3 aside = fromCentre + pass * direction_;
        const double radius = ball.radius + slack;
        const double square = radius * radius - glm::dot(aside, aside);
        if (!(square >= 0)) return kNowhere;
        const double halfChord = std::sqrt(square * inverseSquare_) + slack; // slack for where it passes
        const double enter = std::max(pass - halfChord, nearest_);
        return enter <= farthest && pass + halfChord >= nearest_ ? enter : kNowhere;
    }

private:
    static constexpr double kGamma3 = 3 * 0x1p-53 / (1 - 3 * 0x1p-53);
    dvec3 origin_, direction_, inverse_;
    double inverseSquare_, nearest_;
};

/// Around all that `triangles` lists: the middle of their box, and as far as the farthest corner.
template <typename Primitives>
Ball ballAround(std::span<const Triangle> triangles, const Primitives& primitives) {
    Box box;
    for (const std::uint32_t p : primitives)
        box.include(triangles[p]);
    if (box.isEmpty()) return {};
    Ball ball{box.centre(), 0};
    for (const std::uint32_t p : primitives)
        for (const dvec3* corner : {&triangles[p].a, &triangles[p].b, &triangles[p].c})
            ball.radius = std::max(ball.radius, glm::distance(*corner, ball.centreCentred));
    ball.radius *= 1 + 8 * 0x1p-53; // the distance is rounded six times
    return ball;
}

} // namespace shadowlab::trace
