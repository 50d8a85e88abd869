// Rays along axes, with every sign of zero, from on, in and outside the planes of a box.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "techniques/foundation/trace/bvh/bvh_build.h"
#include "techniques/foundation/trace/bvh/bvh_traverse.h"
#include "tests/foundation/trace/exact_slabs.h"
#include "tests/foundation/trace/ray_meshes.h"

namespace shadowlab::trace {
namespace {

std::vector<const BvhKernels*> allKernels() {
    std::vector<const BvhKernels*> kernels{&kGenericBvhKernels};
    if (const BvhKernels* avx2 = avx2BvhKernels()) kernels.push_back(avx2);
    return kernels;
}

TEST(RayBoxTest, TableOfDirectionsAndOrigins) {
    BvhNode node{};
    node.count = 7;
    for (int axis = 0; axis < 3; ++axis)
        for (int i = 0; i < kBvhWidth; ++i) {
            node.planes[axis][0][i] = i == 7 ? std::numeric_limits<float>::infinity() : -1.0f;
            node.planes[axis][1][i] = i == 7 ? -std::numeric_limits<float>::infinity() : 1.0f;
        }
    const double directions[] = {0.0, -0.0, 1.0, -1.0}, origins[] = {-1, 1, 0, 2, -2};
    int compared = 0, touched = 0;
    for (const BvhKernels* kernels : allKernels())
        for (int d = 0; d < 64; ++d)
            for (int o = 0; o < 125; ++o) {
                const Ray ray{{origins[o % 5], origins[o / 5 % 5], origins[o / 25]},
                              {directions[d % 4], directions[d / 4 % 4], directions[d / 16]}};
                if (!isUsable(ray)) continue;
                BvhWalk walk;
                aim(walk, ray, ShearedRay(ray));
                alignas(32) float enter[kBvhWidth];
                const unsigned mask = kernels->touched(walk, node, enter);
                const bool expected = testing::touchesExactly(ray, -1, 1);
                EXPECT_EQ(mask, expected ? 0x7fu : 0u) // the eighth is no box
                    << kernels->name << ", direction " << d << ", origin " << o;
                ++compared;
                touched += expected;
            }
    EXPECT_EQ(compared, static_cast<int>(allKernels().size()) * 56 * 125);
    EXPECT_GT(touched, 1000);
}

// Straight down onto the vertices and edges of a level grid, whose boxes are flat: each must be hit.
TEST(RayBoxTest, AxisParallelRaysHitFlatThingsInTheTree) {
    for (int axis = 0; axis < 3; ++axis) {
        constexpr int kSide = 20;
        testing::Triangles triangles;
        const auto at = [&](double u, double v) {
            dvec3 p(0);
            p[(axis + 1) % 3] = u * 0.1; // no round numbers
            p[(axis + 2) % 3] = v * 0.1;
            return p;
        };
        for (int i = 0; i < kSide; ++i)
            for (int j = 0; j < kSide; ++j) {
                triangles.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
                triangles.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
            }
        const Bvh bvh = buildBvh(triangles);
        for (int i = 0; i <= 2 * kSide; ++i)
            for (int j = 0; j <= 2 * kSide; ++j)
                for (const double zero : {0.0, -0.0})
                    for (const double along : {1.0, -1.0}) {
                        const bool vertex = i % 2 == 0 && j % 2 == 0;
                        if (!vertex && (i == 0 || j == 0 || i == 2 * kSide || j == 2 * kSide)) continue;
                        Ray ray{at(i / 2.0, j / 2.0), dvec3(zero)};
                        ray.originCentred[axis] = -along;
                        ray.directionCentred[axis] = along;
                        const RayHit hit = bvh.closest(ray);
                        EXPECT_TRUE(hit) << i << ", " << j << " along " << axis;
                        EXPECT_EQ(hit.t, 1.0);
                    }
    }
}

} // namespace
} // namespace shadowlab::trace
