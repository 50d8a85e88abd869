// Is a place inside of a closed body?
//
// On the way to far away, a body is left as often as it is entered if one begins outside. So count, for each body, 1 when its
// surface is met from behind and -1 when it is met from the front: the sum is the winding number, 0 outside.
// SPDX-License-Identifier: MIT
#pragma once
#include <vector>

#include "techniques/foundation/trace/bvh.h"
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
