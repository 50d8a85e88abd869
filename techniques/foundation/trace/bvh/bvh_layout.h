// How the tree lies in memory.
//
// A node's eight boxes stand side by side, and so do a leaf's four triangles: one instruction works on all of them. Each
// fills whole lines of the processor's cache (64 bytes), so that none is fetched for a part of its neighbour.
//
// Plain data, no function with a body: functions compiled for several processors include it, and the linker could keep a
// shared function body with instructions that not every processor has.
// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>

namespace shadowlab::trace {

constexpr int kBvhWidth = 8, kLeafTriangles = 4;

/// planes[axis][0] the lower, planes[axis][1] the upper planes of the children's boxes, rounded outward. A child that is not
/// there has its box inside out, and is never touched. Children that are leaves are stored as the complement of the leaf's
/// number (BvhChild says it in words).
struct alignas(64) BvhNode {
    float planes[3][2][kBvhWidth];
    std::int32_t children[kBvhWidth];
    std::int32_t count; ///< of children that are there: the first of them
};

/// Up to four triangles, in centred space. Unused places repeat the first.
struct alignas(64) BvhLeaf {
    double corners[3][3][kLeafTriangles]; ///< corner, axis, triangle
    std::uint32_t primitives[kLeafTriangles];
    std::int32_t count;
    float largest; ///< no coordinate is larger, without sign
};

} // namespace shadowlab::trace
