// A ray-triangle test that is not watertight, for comparison with the one that is (trace/ray_triangle.h).
//
// T. Moeller and B. Trumbore, "Fast, Minimum Storage Ray/Triangle Intersection", Journal of Graphics Tools 2(1), 1997, in float
// and as it is often written: a hit must lie inside the edges by more than a margin against rounding. Both triangles at an edge
// then reject a ray that comes close to it, and the ray passes between them.
// SPDX-License-Identifier: MIT
#pragma once
#include <memory>
#include <optional>

#include "techniques/foundation/trace/structures/engine.h"

namespace shadowlab::ray_tracing {

struct NaiveHit {
    float t; ///< in lengths of the ray's direction
    vec3 barycentric;
};

/// The intersection of the ray's line with the triangle, if all its barycentric weights are larger than `margin`. A weight is the
/// distance of the hit from one edge, relative to the triangle's height over that edge.
std::optional<NaiveHit> naiveHit(const trace::Ray& ray, const trace::Triangle& triangle, float margin);

/// An engine that traverses the tree, which must outlive it, with the naive test.
std::unique_ptr<trace::Engine> makeNaiveEngine(const trace::Bvh& bvh, float margin);

} // namespace shadowlab::ray_tracing
