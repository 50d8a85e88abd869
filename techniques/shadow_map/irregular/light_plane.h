// The light's picture plane: where points lie in it, as the light sees them. Not a picture: no pixels, no resolution.
//
// A directional light needs one plane, at right angles to its rays. A point light needs one when all samples lie within a cone before
// it, and otherwise six, the faces of a cube around it. Unlike a shadow map's cameras (light_maps.h) they
// are fitted to the samples, not to casters, and composed in double throughout.
// SPDX-License-Identifier: MIT
#pragma once
#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <vector>

#include "techniques/foundation/scene/model/light.h"

namespace shadowlab::shadow_map {

/// A rectangle of the plane, empty at first.
struct PlaneRect {
    dvec2 lower{std::numeric_limits<double>::infinity()}, upper{-std::numeric_limits<double>::infinity()};
    void include(const dvec2& place) {
        lower = glm::min(lower, place);
        upper = glm::max(upper, place);
    }
    void include(const PlaneRect& other) {
        lower = glm::min(lower, other.lower);
        upper = glm::max(upper, other.upper);
    }
    [[nodiscard]] bool isEmpty() const { return !(lower.x <= upper.x && lower.y <= upper.y); }
};

/// One plane, and how to find what lies where in it.
struct LightPlane {
    bool parallel = false;
    dvec3 originCentred{0.0};    ///< the light; of parallel light, the origin of centred space
    dmat3 planeFromCentred{1.0}; ///< its rows: the axes of u and v, and the depth; of parallel light, toward the sun

    /// Along the plane's axes, seen from its origin.
    [[nodiscard]] dvec3 alongAxes(const dvec3& positionCentred) const {
        return planeFromCentred * (positionCentred - originCentred);
    }
    /// Two places in the plane, u and v, and the *nearness*, which is larger the nearer a thing is to the light: one over its
    /// depth, or, of parallel light, the metres toward the sun. On a triangle it is a linear function of u and v.
    [[nodiscard]] dvec3 place(const dvec3& positionCentred) const {
        const dvec3 p = alongAxes(positionCentred);
        return parallel ? p : dvec3(p.x, p.y, 1.0) / p.z;
    }
    /// The point that has this place: for pictures that show the plane, or what lies in it.
    [[nodiscard]] dvec3 positionCentred(const dvec3& place) const {
        const dvec3 p = parallel ? place : dvec3(place.x, place.y, 1.0) / place.z;
        return originCentred + glm::transpose(planeFromCentred) * p;
    }
};

/// A box around places of one plane.
struct PlaceBox {
    PlaneRect rect;
    double farthest = std::numeric_limits<double>::infinity(), nearest = -farthest; ///< least and most nearness
    void include(const dvec3& place) {
        rect.include(dvec2(place));
        farthest = std::min(farthest, place.z);
        nearest = std::max(nearest, place.z);
    }
    void include(const PlaceBox& other) {
        rect.include(other.rect);
        farthest = std::min(farthest, other.farthest);
        nearest = std::max(nearest, other.nearest);
    }
    /// No coordinate along the plane's axes (LightPlane::alongAxes) is larger, of anything that is in the box: bounds for
    /// rounding grow with it.
    [[nodiscard]] double largestCoordinate(bool parallel) const {
        const dvec2 aside = glm::max(glm::abs(rect.lower), glm::abs(rect.upper));
        const double most = std::max(aside.x, aside.y);
        return parallel ? std::max({most, std::abs(farthest), std::abs(nearest)}) : std::max(most, 1.0) / farthest;
    }
};

/// Places of one plane are at most so far from its middle, in units of depth, where light is not parallel. The bounds for
/// rounding (seen_triangle.h) are made for it.
constexpr double kWidestPlane = 2;

/// The planes of one light.
class LightPlanes {
public:
    /// One plane; that of a light that is a point looks toward `middleCentred`.
    static LightPlanes one(const scene::Light& light, const dvec3& originWorld, const dvec3& middleCentred);
    /// The six faces of a cube around a light that is a point.
    static LightPlanes cube(const scene::Light& light, const dvec3& originWorld);

    [[nodiscard]] std::span<const LightPlane> all() const { return planes_; }
    /// The plane a point belongs to: exactly one, or -1 where it has no place at all (the light itself, no number).
    [[nodiscard]] int planeOf(const dvec3& positionCentred) const;

private:
    std::vector<LightPlane> planes_;
};

} // namespace shadowlab::shadow_map
