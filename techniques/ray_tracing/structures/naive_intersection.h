// A ray-triangle test that is not watertight, to be held against the one that is (trace/ray_triangle.h).
//
// Moeller and Trumbore, "Fast, Minimum Storage Ray/Triangle Intersection", Journal of Graphics Tools 2(1), 1997, in float and
// as it is often written: a hit has to lie inside the edges by more than a margin against rounding. The triangles on the two
// sides of an edge both refuse what comes close to it, and the ray passes between them.
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

/// Where the ray, however long, hits the triangle, if its barycentric weights are all larger than `margin` there. A weight is
/// how far inside one edge the hit lies, as a share of the triangle's height over that edge.
std::optional<NaiveHit> naiveHit(const trace::Ray& ray, const trace::Triangle& triangle, float margin);

/// An engine that walks the tree, which outlives it, and believes the naive test.
std::unique_ptr<trace::Engine> makeNaiveEngine(const trace::Bvh& bvh, float margin);

} // namespace shadowlab::ray_tracing
