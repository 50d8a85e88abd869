// One ray on its way through the tree.
//
// A walk goes from leaf to leaf, nearest first, and stops at each in which the ray may hit something. The caller
// (bvh_traverse.h) decides which of these it does hit, with the test that all structures share; then the walk goes on. So
// only the search for candidates is compiled per kind of processor; the decision is compiled once.
//
// Plain data, no function with a body, for the reason that bvh_layout.h gives.
// SPDX-License-Identifier: MIT
#pragma once
#include "techniques/foundation/trace/bvh/bvh_layout.h"

namespace shadowlab::trace {

struct BvhWalk {
    /// Up to seven siblings wait at every one of at most 64 levels.
    static constexpr int kMostWaiting = (kBvhWidth - 1) * 64 + kBvhWidth;

    const BvhNode* nodes;
    const BvhLeaf* leaves;

    // The ray as boxes see it (ray_box.h). Distances are in units of reach (ray_triangle.h), here and below.
    float inverseEnter[3], inverseLeave[3], originEnter[3], originLeave[3];
    std::int32_t nearSide[3]; ///< of a box, that the ray meets first: 0 the lower, 1 the upper
    float nearestBox, farthestBox;

    // And as triangles see it: ShearedRay's numbers, the origin's coordinates in the order of its axes.
    std::int32_t axes[3];
    double origin[3], shearX, shearY, sign, nearest, farthest;
    double largest; ///< coordinate of the origin, without sign

    const BvhLeaf* leaf; ///< where the walk has stopped
    // What intersect() would find out there about those triangles that are hit for certain (one bit each): the three sides and
    // where, by the same operations. Of the others it must be asked.
    unsigned certain;
    alignas(32) double sides[3][kLeafTriangles], reach[kLeafTriangles];
    std::uint64_t nodesSeen, boxesTried, leavesSeen, trianglesTried;

    int size; ///< of the stack
    std::uint64_t
        stack[kMostWaiting]; ///< children that wait: where the ray enters the box (bits of a float), the child
};

/// The same functions, compiled for one kind of processor, with the same bits.
struct BvhKernels {
    const char* name;
    /// One bit for each child whose box the ray may touch before farthestBox; `enter` (aligned to 32 bytes) receives where.
    unsigned (*touched)(const BvhWalk& walk, const BvhNode& node, float* enter);
    /// Goes on to the next leaf, nearest first, and returns one bit for each triangle that the ray may hit beyond `nearest` and
    /// not beyond `farthest`; 0: there is none left. Nothing is left out that intersect() would hit.
    unsigned (*nearest)(BvhWalk& walk);
    /// The same in no particular order, which is quicker where any hit will do.
    unsigned (*any)(BvhWalk& walk);
};

extern const BvhKernels kGenericBvhKernels;
/// With eight lanes of AVX2; nothing where the compiler or the processor has none.
const BvhKernels* avx2BvhKernels();
/// The quickest that this processor can run.
const BvhKernels& bestBvhKernels();

} // namespace shadowlab::trace
