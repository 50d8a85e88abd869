// Queries of the tree. A walk (bvh_walk.h) finds the triangles that a ray may hit, leaf by leaf; intersect() decides here
// whether it does.
// SPDX-License-Identifier: MIT
#pragma once
#include <bit>

#include "techniques/foundation/trace/bvh/bvh.h"
#include "techniques/foundation/trace/bvh/ray_box.h"

namespace shadowlab::trace {

namespace detail {

inline void begin(BvhWalk& walk, const Bvh& bvh, const Ray& ray, const ShearedRay& sheared) {
    walk.nodes = bvh.nodes.data();
    walk.leaves = bvh.leaves.data();
    aim(walk, ray, sheared);
    walk.nodesSeen = walk.boxesTried = walk.leavesSeen = walk.trianglesTried = 0;
    walk.size = 1;
    walk.stack[0] = 0; // the root, entered at once
}

/// What intersect() says of a candidate where the walk has stopped.
inline std::optional<TriangleHit> hitOf(const BvhWalk& walk, const ShearedRay& sheared, int i, double farthest) {
    if (!(walk.certain >> i & 1)) return intersect(sheared, triangleOf(*walk.leaf, i), farthest);
    if (!(walk.reach[i] <= farthest)) return std::nullopt; // beyond what was hit in the meantime
    const double u = walk.sides[0][i], v = walk.sides[1][i], w = walk.sides[2][i];
    return TriangleHit{walk.reach[i], dvec3(u, v, w) / (u + v + w)};
}

template <typename Count>
void report(const BvhWalk& walk, const Count& count) {
    count.volumes(walk.boxesTried);
    count.triangles(walk.trianglesTried);
    count.steps(walk.nodesSeen + walk.leavesSeen);
}

} // namespace detail

template <typename Accept, typename InHole, typename Count>
RayHit Bvh::closest(const Ray& ray, const Accept& accept, const InHole& inHole, Count count) const {
    RayHit best;
    if (nodes.empty() || !isUsable(ray)) return best;
    const ShearedRay sheared(ray);
    BvhWalk walk;
    detail::begin(walk, *this, ray, sheared);
    while (unsigned left = kernels->nearest(walk)) {
        for (; left != 0; left &= left - 1) {
            const int i = std::countr_zero(left);
            const std::uint32_t primitive = walk.leaf->primitives[i];
            if (!accept(primitive)) continue;
            const auto hit = detail::hitOf(walk, sheared, i, walk.farthest);
            if (!hit || !(hit->reach < walk.farthest || (best && primitive < best.primitive))) continue;
            if (inHole(primitive, hit->barycentric)) continue;
            walk.farthest = hit->reach;
            walk.farthestBox = reachInFloat(hit->reach);
            best = {0, primitive, hit->barycentric};
        }
    }
    detail::report(walk, count);
    if (best) best.t = walk.farthest / sheared.reachPerT;
    return best;
}

inline RayHit Bvh::closest(const Ray& ray) const {
    return closest(ray, [](std::uint32_t) { return true; });
}

template <typename Accept, typename InHole, typename Count>
std::uint32_t Bvh::any(const Ray& ray, const Accept& accept, const InHole& inHole, Count count) const {
    if (nodes.empty() || !isUsable(ray)) return kNoPrimitive;
    const ShearedRay sheared(ray);
    BvhWalk walk;
    detail::begin(walk, *this, ray, sheared);
    std::uint32_t found = kNoPrimitive;
    while (unsigned left = found == kNoPrimitive ? kernels->any(walk) : 0) {
        for (; left != 0 && found == kNoPrimitive; left &= left - 1) {
            const int i = std::countr_zero(left);
            const std::uint32_t primitive = walk.leaf->primitives[i];
            if (!accept(primitive)) continue;
            const auto hit = detail::hitOf(walk, sheared, i, sheared.farthest);
            if (hit && hit->reach < sheared.farthest && !inHole(primitive, hit->barycentric)) found = primitive;
        }
    }
    detail::report(walk, count);
    return found;
}

} // namespace shadowlab::trace
