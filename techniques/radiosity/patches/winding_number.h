// The winding number of closed surfaces around a point: how often they enclose it. A point is inside a closed body where the
// winding number of that body is not 0.
//
// A ray from a point outside enters a body as often as it leaves it. So each hit from behind, where the ray leaves, counts 1, and
// each hit from the front, where it enters, counts -1: the sum is 0 outside of all bodies.
// SPDX-License-Identifier: MIT
#pragma once
#include <vector>

#include "techniques/foundation/trace/bvh/bvh.h"
#include "techniques/foundation/trace/world_triangles.h"

namespace shadowlab::radiosity {

/// The contribution of one triangle that a ray hits to the winding number at the ray's origin.
inline int windingOf(const trace::Triangle& triangle, const dvec3& direction) {
    return glm::dot(glm::cross(triangle.b - triangle.a, triangle.c - triangle.a), direction) > 0 ? 1 : -1;
}

class ClosedBodies {
public:
    /// The first two must outlive this object. `isClosed`: for each object of the scene.
    ClosedBodies(const trace::Bvh& bvh, const trace::WorldTriangles& world, std::vector<bool> isClosed)
        : bvh_(bvh), world_(world), isClosed_(std::move(isClosed)) {}

    /// Is the point inside any of them? `directionCentred` leads away from the surface that the point lies on.
    [[nodiscard]] bool contain(const dvec3& placeCentred, const dvec3& directionCentred) const;

private:
    const trace::Bvh& bvh_;
    const trace::WorldTriangles& world_;
    std::vector<bool> isClosed_;
};

} // namespace shadowlab::radiosity
