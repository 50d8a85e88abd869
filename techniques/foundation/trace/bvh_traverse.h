// Asking the tree. Iterative, with a stack of its own: children are put aside, the nearest is looked into first.
// SPDX-License-Identifier: MIT
#pragma once
#include <bit>

#include "techniques/foundation/trace/bvh.h"

namespace shadowlab::trace {

namespace detail {

struct StackEntry {
    BvhChild child;
    float enter; ///< where the ray enters its box
};

/// Up to three siblings wait at every level.
using Stack = std::array<StackEntry, 3 * Bvh::kMostDepth + 4>;

/// A little more than the distance, in float: what is in double not beyond it is not beyond it in float either.
inline float reachInFloat(double reach) { return roundedUp(reach * (1 + 1e-6)); }

} // namespace detail

template <typename Accept, typename InHole, typename Count>
RayHit Bvh::closest(const Ray& ray, const Accept& accept, const InHole& inHole, Count count) const {
    RayHit best;
    if (nodes.empty() || !isUsable(ray)) return best;
    const ShearedRay sheared(ray);
    const SlabRay slabs(ray, sheared);
    const FilterRay filter(sheared);
    double farthest = sheared.farthest;
    float farthestBox = detail::reachInFloat(farthest);

    detail::Stack stack;
    std::size_t size = 0;
    stack[size++] = {BvhChild::node(0), 0.0f};
    while (size > 0) {
        const detail::StackEntry entry = stack[--size];
        if (entry.enter > farthestBox) continue; // something nearer was found in the meantime
        count.step();
        if (entry.child.isLeaf()) {
            const FourTriangles& four = leaves[entry.child.index()];
            count.triangles(four.count);
            for (int left = filter.candidates(four); left != 0; left &= left - 1) {
                const std::uint32_t primitive = four.primitives[std::countr_zero(static_cast<unsigned>(left))];
                const auto hit = intersect(sheared, triangles[primitive], farthest);
                if (!hit || !accept(primitive)) continue;
                if (!(hit->reach < farthest || (best && primitive < best.primitive))) continue;
                if (inHole(primitive, hit->barycentric)) continue;
                farthest = hit->reach;
                farthestBox = detail::reachInFloat(farthest);
                best = {0, primitive, hit->barycentric};
            }
            continue;
        }
        const BvhNode& node = nodes[entry.child.index()];
        count.volumes(4);
        Float4 enter4{};
        int touched = slabs.touched(node.boxes, farthestBox, enter4);
        alignas(16) float enter[4];
        enter4.store(enter);
        // Farthest first onto the stack: an insertion sort of at most four.
        const std::size_t first = size;
        for (; touched != 0; touched &= touched - 1) {
            const int i = std::countr_zero(static_cast<unsigned>(touched));
            std::size_t place = size++;
            for (; place > first && stack[place - 1].enter < enter[i]; --place)
                stack[place] = stack[place - 1];
            stack[place] = {node.children[static_cast<std::size_t>(i)], enter[i]};
        }
    }
    if (best) best.t = farthest / sheared.reachPerT;
    return best;
}

inline RayHit Bvh::closest(const Ray& ray) const {
    return closest(ray, [](std::uint32_t) { return true; });
}

template <typename Accept, typename InHole, typename Count>
std::uint32_t Bvh::any(const Ray& ray, const Accept& accept, const InHole& inHole, Count count) const {
    if (nodes.empty() || !isUsable(ray)) return kNoPrimitive;
    const ShearedRay sheared(ray);
    const SlabRay slabs(ray, sheared);
    const FilterRay filter(sheared);
    const float farthestBox = detail::reachInFloat(sheared.farthest);

    std::array<BvhChild, std::tuple_size_v<detail::Stack>> stack;
    std::size_t size = 0;
    stack[size++] = BvhChild::node(0);
    while (size > 0) {
        const BvhChild child = stack[--size];
        count.step();
        if (child.isLeaf()) {
            const FourTriangles& four = leaves[child.index()];
            count.triangles(four.count);
            for (int left = filter.candidates(four); left != 0; left &= left - 1) {
                const std::uint32_t primitive = four.primitives[std::countr_zero(static_cast<unsigned>(left))];
                if (!accept(primitive)) continue;
                const auto hit = intersect(sheared, triangles[primitive], sheared.farthest);
                if (hit && hit->reach < sheared.farthest && !inHole(primitive, hit->barycentric)) return primitive;
            }
            continue;
        }
        const BvhNode& node = nodes[child.index()];
        count.volumes(4);
        Float4 enter{};
        for (int touched = slabs.touched(node.boxes, farthestBox, enter); touched != 0; touched &= touched - 1)
            stack[size++] = node.children[static_cast<std::size_t>(std::countr_zero(static_cast<unsigned>(touched)))];
    }
    return kNoPrimitive;
}

} // namespace shadowlab::trace
