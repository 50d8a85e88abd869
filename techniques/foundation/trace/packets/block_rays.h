// The rays of a block of pixels, traced together.
//
// Rays that leave one point (the eye, a point light), or run in one direction (the sun), are the points of a plane: cut
// them with a plane across, and each is told from the others by two numbers, x and y. A triangle, seen from there, is a
// triangle of that plane, and "does the ray hit it?" is three linear functions of x and y, one for each edge: eight rays
// are asked by a few instructions. These are the edge functions of a rasteriser (Pineda, "A Parallel Algorithm for Polygon
// Rasterization", SIGGRAPH 1988), but used in a tree, for shadow rays as well, and without rounding errors: the functions
// are set up in double and evaluated in float, with a bound for their error. Within that bound a pair of ray and triangle
// is returned as a doubt, which the caller decides by a single ray. So the answers are exactly those of single rays.
// Tracing such a bundle through a tree: Reshetov, Soupikov and Hurley, "Multi-Level Ray Tracing Algorithm", SIGGRAPH 2005.
//
// Nothing but plain data is declared here, no function with a body: this file is compiled for several processors, and the
// linker could keep a shared function body with instructions that not every processor has.
// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>

#include "techniques/foundation/trace/bvh/bvh_layout.h"

namespace shadowlab::trace {

constexpr int kBlockSide = 8, kBlockRays = kBlockSide * kBlockSide;

struct BlockTreeView {
    const BvhNode* nodes;
    const BvhLeaf* leaves;
    float largest; ///< of all coordinates of the boxes, without sign
    /// One flag for each primitive: it has holes. What may hit it is handed back as a doubt, always. Null: none has any.
    const std::uint8_t* perforated;
};

/// Up to 64 rays. Of a point seen from `origin`, K is its depth along the main axis, counted in the direction of the
/// rays; its place in the plane is
///     perspective: its other two coordinates divided by K, less `shear`; parallel: these coordinates less `shear` times K.
/// x and y count along axes of the block's own (`basis`), so that its rows lie level and bound closely what they may hit.
/// A hit's `value` is the larger the nearer it is to where the rays come from: 1 / K, or, parallel, K itself (the rays
/// run toward the sun, and what is nearer to it wins).
struct BlockRays {
    alignas(32) float x[kBlockRays], y[kBlockRays];
    alignas(32) float floor[kBlockRays]; ///< only hits of a larger value count (shadow rays: that of the point itself)
    std::uint64_t asked;                 ///< one bit for each ray that is there at all
    double origin[3];
    double shear[2];
    double sign;  ///< +1, or -1 where the rays run against the main axis
    int axes[3];  ///< of x, of y, and the main axis
    int parallel; ///< 0 or 1
    double basis[2]
                [2];  ///< of the plane: the rays are at x * basis[0] + y * basis[1], along the block's rows and columns
    float radius[2];  ///< all |x|, all |y| are at most this
    float span[2];    ///< and all places, along the axes, this
    double largest;   ///< coordinate of any of the points that rays start or end at, seen from the origin
    float floorError; ///< how far beyond its floor a value must be to count certainly
    float ceiling[2]; ///< value at the near plane: certainly beyond it below the first, before it above the second
    float nearest, farthest; ///< K of where rays may be hit
};

/// A ray and a triangle that float could not decide about.
struct BlockDoubt {
    std::uint32_t ray, primitive;
};

struct BlockAnswers {
    static constexpr int kMostDoubts = 192;                ///< three per ray; a ray with more is better traced alone
    alignas(32) float least[kBlockRays], most[kBlockRays]; ///< value of the nearest certain hit lies between
    std::uint32_t primitives[kBlockRays];                  ///< of the nearest certain hit; ~0u: none
    BlockDoubt doubts[kMostDoubts];                        ///< what may be hit, and may be nearer
    int doubtCount;
    std::uint64_t blocked; ///< shadow rays: those that are certainly hit
    std::uint64_t
        givenUp; ///< rays with more doubts than there is room for, or all when the block was not worth its while
};

/// What 64 eye rays are made of: that through column i and row j of the block runs along column[i] + row[j] + back.
struct BlockFan {
    double column[3][kBlockSide], row[3][kBlockSide], back[3]; ///< axis first
};

/// Points on triangles, side by side.
struct BlockPoints {
    std::uint32_t primitives[kBlockRays];      ///< always of some triangle, whether the point is asked for or not
    alignas(32) double weights[2][kBlockRays]; ///< of corners a and b
    std::uint64_t eyeOnFront;
    std::uint64_t open; ///< those that double cannot decide: to be traced alone
};

/// Vectors side by side, axis first.
struct alignas(32) BlockVectors {
    double axis[3][kBlockRays];
};

/// The same functions, compiled for one kind of processor. `triangles` holds nine doubles for each: corners a, b, c.
struct BlockKernels {
    const char* name;

    /// Makes the rays of a fan, and puts them into the plane (BlockRays::x, y, shear, radius, axes, sign): false where
    /// they have no common main axis. `depth` receives the least and the largest of their parts along it.
    bool (*aimFan)(const BlockFan& fan, BlockRays& rays, BlockVectors& directions, double depth[2]);
    /// The nearest certain hit of each ray, and all that could be nearer.
    void (*nearest)(const BlockTreeView& tree, const BlockRays& rays, BlockAnswers& answers);
    /// Where in its triangle each ray that is asked ends: the arithmetic of intersect() (ray_triangle.h), operation by operation.
    void (*land)(const double* triangles, const BlockRays& rays, const BlockVectors& directions, double nearest,
                 BlockPoints& points);

    /// Where the points are: the arithmetic of SceneTracer::positionCentred().
    void (*positions)(const double* triangles, const BlockPoints& points, BlockVectors& positions);
    /// Puts the rays from a light (or toward the sun, then rays.shear is set) through these points into the plane, and
    /// their floors. Returns those that have the block's main axis; the others must not be asked.
    std::uint64_t (*aimAtPoints)(const BlockVectors& positions, double contact, BlockRays& rays);
    /// If the rays form two clusters with a gap between (on one object and on another behind it, say): those of one
    /// cluster, because each alone is a narrower bundle. Else 0.
    std::uint64_t (*part)(const BlockRays& rays);
    /// Which rays are certainly blocked, by a triangle that `mayBlock` (one flag each) and is not the ray's own; and
    /// what may block the others.
    void (*blocked)(const BlockTreeView& tree, const BlockRays& rays, const std::uint8_t* mayBlock,
                    const std::uint32_t* own, BlockAnswers& answers);
};

extern const BlockKernels kGenericBlockKernels;
/// With eight lanes of AVX2; nothing where the compiler or the processor has none.
const BlockKernels* avx2BlockKernels();
/// The quickest that this processor can run.
const BlockKernels& bestBlockKernels();

} // namespace shadowlab::trace
