// A ray, its hit, and counters for what it tested.
//
// The tracer computes in *centred* space: world axes, origin at a point of the scene's own choosing
// (world_triangles.h), so that a scene a million metres away from the world's origin keeps every digit.
// SPDX-License-Identifier: MIT
#pragma once
#include <cmath>
#include <cstdint>
#include <limits>

#include "techniques/foundation/math/types.h"

namespace shadowlab::trace {

/// Points origin + t * direction with nearest < t < farthest. The direction may have any length but zero.
struct Ray {
    dvec3 originCentred{0.0}, directionCentred{0.0, 0.0, -1.0};
    double nearest = 0;
    double farthest = std::numeric_limits<double>::infinity();
};

constexpr std::uint32_t kNoPrimitive = ~std::uint32_t{0};

struct RayHit {
    double t = std::numeric_limits<double>::infinity();
    std::uint32_t primitive = kNoPrimitive;
    dvec3 barycentric{0.0}; ///< weights of the triangle's corners, of sum one
    explicit operator bool() const { return primitive != kNoPrimitive; }
};

/// Can anything be hit at all? False when a number is not finite, or the direction is zero.
inline bool isUsable(const Ray& ray) {
    const dvec3 &o = ray.originCentred, &d = ray.directionCentred;
    const bool finite = std::isfinite(o.x) && std::isfinite(o.y) && std::isfinite(o.z) && std::isfinite(d.x) &&
                        std::isfinite(d.y) && std::isfinite(d.z);
    return finite && (d.x != 0 || d.y != 0 || d.z != 0) && ray.nearest < ray.farthest;
}

struct RayTests {
    std::uint64_t volumes = 0;   ///< bounding volumes
    std::uint64_t triangles = 0; ///< a triangle tried twice counts twice
    std::uint64_t steps = 0;     ///< nodes or cells looked into
    [[nodiscard]] std::uint64_t all() const { return volumes + triangles; }
};

struct CountNothing {
    void volumes(std::uint64_t) const {}
    void triangles(std::uint64_t) const {}
    void steps(std::uint64_t) const {}
    void step() const {}
};

struct CountTests {
    RayTests& tests;
    void volumes(std::uint64_t count) const { tests.volumes += count; }
    void triangles(std::uint64_t count) const { tests.triangles += count; }
    void steps(std::uint64_t count) const { tests.steps += count; }
    void step() const { ++tests.steps; }
};

} // namespace shadowlab::trace
