// Is a place inside of a closed body? It is where the winding number (winding.h) of one body is not zero.
// SPDX-License-Identifier: MIT
#pragma once
#include <vector>

#include "techniques/foundation/trace/bvh/bvh.h"
#include "techniques/foundation/trace/world_triangles.h"

namespace shadowlab::radiosity {

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
