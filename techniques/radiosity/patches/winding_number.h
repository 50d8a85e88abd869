// The winding number of closed surfaces around a place: how often they enclose it.
//
// On the way to far away a body is left as often as it is entered, if one begins outside. So count 1 where a surface is met from
// behind, on the way out, and -1 where it is met from the front, on the way in: the sum is 0 outside of everything.
//
// Is a place inside of a closed body? It is where the winding number (winding.h) of one body is not zero.
// SPDX-License-Identifier: MIT
#pragma once
#include <vector>

#include "techniques/foundation/trace/bvh/bvh.h"
#include "techniques/foundation/trace/world_triangles.h"

namespace shadowlab::radiosity {

/// What one triangle that a ray meets adds to the winding number of the place that the ray begins at.
inline int windingOf(const trace::Triangle& triangle, const dvec3& direction) {
    return glm::dot(glm::cross(triangle.b - triangle.a, triangle.c - triangle.a), direction) > 0 ? 1 : -1;
}

class ClosedBodies {
public:
    /// The first two must live as long. `isClosed`: of each object of the scene.
    ClosedBodies(const trace::Bvh& bvh, const trace::WorldTriangles& world, std::vector<bool> isClosed)
        : bvh_(bvh), world_(world), isClosed_(std::move(isClosed)) {}

    /// Does any of them contain the place? The direction is one that leads away from the surface that the place lies on.
    [[nodiscard]] bool contain(const dvec3& placeCentred, const dvec3& directionCentred) const;

private:
    const trace::Bvh& bvh_;
    const trace::WorldTriangles& world_;
    std::vector<bool> isClosed_;
};

} // namespace shadowlab::radiosity
