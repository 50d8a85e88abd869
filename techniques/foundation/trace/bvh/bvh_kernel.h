// How a ray finds its way through the tree (bvh_walk.h says what a walk is). Included by one file for each kind of processor;
// everything has internal linkage, so that each keeps its own.
//
// Boxes are tested in float, eight at a time, and no box that the ray touches is left out: ray_box.h says why. Triangles
// are tested in double, four at a time, by the operations of intersect() (ray_triangle.h) in the same order. Their decision
// is final, except where a side is so close to zero that only exact arithmetic can decide its sign; such a triangle stays a
// candidate at any distance.
// SPDX-License-Identifier: MIT
#pragma once
#include "techniques/foundation/trace/bvh/bvh_walk.h"
#include "techniques/foundation/trace/packets/block_lanes.h"

namespace shadowlab::trace {
namespace {

/// Largest error of a side, in squares of the largest coordinate as seen from the origin: sideBound() of ray_triangle.h.
constexpr double kSideRounding = 70 * 0x1p-53;

/// The numbers of the ray that box tests use, copied to all lanes.
class BoxRay {
public:
    explicit BoxRay(const BvhWalk& walk) : nearest_(all(walk.nearestBox)) {
        for (int axis = 0; axis < 3; ++axis) {
            inverseEnter_[axis] = all(walk.inverseEnter[axis]);
            inverseLeave_[axis] = all(walk.inverseLeave[axis]);
            originEnter_[axis] = all(walk.originEnter[axis]);
            originLeave_[axis] = all(walk.originLeave[axis]);
            in_[axis] = 2 * kBvhWidth * axis + kBvhWidth * walk.nearSide[axis];
            out_[axis] = 2 * kBvhWidth * axis + kBvhWidth * (1 - walk.nearSide[axis]);
        }
    }
    unsigned touched(const BvhNode& node, float farthest, Float8& enter) const {
        const float* const planes = &node.planes[0][0][0];
        enter = nearest_;
        Float8 leave = all(farthest);
        for (int axis = 0; axis < 3; ++axis) {
            enter = larger((eightOf(planes + in_[axis]) - originEnter_[axis]) * inverseEnter_[axis], enter);
            leave = smaller((eightOf(planes + out_[axis]) - originLeave_[axis]) * inverseLeave_[axis], leave);
        }
        return bits(enter <= leave);
    }

private:
    Float8 inverseEnter_[3], inverseLeave_[3], originEnter_[3], originLeave_[3], nearest_;
    int in_[3], out_[3]; ///< where in a node the planes begin that the ray meets first, and last
};

/// One bit for each triangle that intersect() may hit.
inline unsigned candidates(BvhWalk& walk, const BvhLeaf& leaf) {
    Double4 x[3], y[3], z[3];
    const Double4 shearX = all(walk.shearX), shearY = all(walk.shearY);
    for (int c = 0; c < 3; ++c) {
        z[c] = fourOf(leaf.corners[c][walk.axes[2]]) - all(walk.origin[2]);
        x[c] = (fourOf(leaf.corners[c][walk.axes[0]]) - all(walk.origin[0])) - shearX * z[c];
        y[c] = (fourOf(leaf.corners[c][walk.axes[1]]) - all(walk.origin[1])) - shearY * z[c];
    }
    const Double4 u = x[2] * y[1] - y[2] * x[1], v = x[0] * y[2] - y[0] * x[2], w = x[1] * y[0] - y[1] * x[0];
    const double most = static_cast<double>(leaf.largest) + walk.largest;
    const Double4 bound = all(kSideRounding * most * most);
    const Double4 least = smaller(u, smaller(v, w)), greatest = larger(u, larger(v, w));
    const unsigned there = (1u << leaf.count) - 1;
    const unsigned left = ~bits((least < -bound) & (greatest > bound)) & there;
    if (!left) return 0;
    const Double4 reach = all(walk.sign) * (u * z[0] + v * z[1] + w * z[2]) / (u + v + w);
    const Mask4 certain = (least > bound) | (greatest < -bound);
    const unsigned found = left & ~bits(certain & ~((reach > all(walk.nearest)) & (reach <= all(walk.farthest))));
    if (!found) return 0;
    walk.certain = bits(certain);
    const Double4 sides[3] = {u, v, w};
    for (int side = 0; side < 3; ++side)
        store(walk.sides[side], sides[side]);
    store(walk.reach, reach);
    return found;
}

// Where a ray enters a box, and which child that is, in one number, so that one comparison orders both without a branch,
// which would be mispredicted half of the time. (No ray enters before its beginning, and of floats that are not negative
// the bits have the order of the numbers.)
inline std::uint64_t waiting(const BvhNode& node, const float* enter, unsigned touched) {
    const int i = __builtin_ctz(touched);
    return std::uint64_t{__builtin_bit_cast(std::uint32_t, enter[i])} << 32 |
           static_cast<std::uint32_t>(node.children[i]);
}
inline float enterOf(std::uint64_t waiting) {
    return __builtin_bit_cast(float, static_cast<std::uint32_t>(waiting >> 32));
}
inline std::int32_t childOf(std::uint64_t waiting) { return static_cast<std::int32_t>(waiting); }

inline void order(std::uint64_t& nearer, std::uint64_t& farther) {
    const std::uint64_t a = nearer, b = farther;
    nearer = a < b ? a : b;
    farther = a < b ? b : a;
}

/// Of two children or more, puts all but one onto the stack, and returns that one: if `kSorted` the nearest, with the farther
/// ones below the nearer.
template <bool kSorted>
inline std::int32_t pushAllButOne(std::uint64_t*& top, const BvhNode& node, unsigned touched, const float* enter) {
    if constexpr (!kSorted) {
        for (; touched & (touched - 1); touched &= touched - 1)
            *top++ = waiting(node, enter, touched);
        return node.children[__builtin_ctz(touched)];
    }
    const auto next = [&] {
        const std::uint64_t one = waiting(node, enter, touched);
        touched &= touched - 1;
        return one;
    };
    std::uint64_t first = next(), second = next();
    order(first, second);
    if (touched == 0) { // two are by far the most frequent
        *top++ = second;
        return childOf(first);
    }
    std::uint64_t third = next();
    order(first, third);
    order(second, third);
    std::uint64_t* const bottom = top;
    *top++ = third;
    *top++ = second;
    while (touched != 0) { // more: an insertion sort of at most eight
        std::uint64_t one = next();
        order(first, one);
        std::uint64_t* place = top++;
        for (; place > bottom && place[-1] < one; --place)
            *place = place[-1];
        *place = one;
    }
    return childOf(first);
}

/// `kSorted`: nearest first.
template <bool kSorted>
unsigned nextCandidates(BvhWalk& walk) {
    const BoxRay ray(walk);
    const float farthest = walk.farthestBox;
    const BvhNode* const nodes = walk.nodes;
    std::uint64_t* top = walk.stack + walk.size;
    std::uint64_t nodesSeen = 0, boxesTried = 0, leavesSeen = 0, trianglesTried = 0;
    unsigned found = 0;
    while (found == 0 && top != walk.stack) {
        const std::uint64_t next = *--top;
        if (enterOf(next) > farthest) continue; // a nearer hit has been found since
        std::int32_t child = childOf(next);
        unsigned touched = 1;
        while (child >= 0) {
            const BvhNode& node = nodes[child];
            ++nodesSeen;
            boxesTried += static_cast<std::uint64_t>(node.count);
            Float8 enter8;
            touched = ray.touched(node, farthest, enter8);
            if (touched == 0) break;
            if (touched & (touched - 1)) {
                alignas(32) float enter[kBvhWidth];
                store(enter, enter8);
                child = pushAllButOne<kSorted>(top, node, touched, enter);
            } else {
                child = node.children[__builtin_ctz(touched)];
            }
        }
        if (touched == 0) continue;
        const BvhLeaf& leaf = walk.leaves[~child];
        ++leavesSeen;
        trianglesTried += static_cast<std::uint64_t>(leaf.count);
        found = candidates(walk, leaf);
        walk.leaf = &leaf;
    }
    walk.size = static_cast<int>(top - walk.stack);
    walk.nodesSeen += nodesSeen;
    walk.boxesTried += boxesTried;
    walk.leavesSeen += leavesSeen;
    walk.trianglesTried += trianglesTried;
    return found;
}

inline unsigned touchedBoxes(const BvhWalk& walk, const BvhNode& node, float* enter) {
    Float8 enter8;
    const unsigned touched = BoxRay(walk).touched(node, walk.farthestBox, enter8);
    store(enter, enter8);
    return touched;
}

} // namespace
} // namespace shadowlab::trace
