// The tree of a pixel ray in words, numbers and lines: what `probe` prints and the scene shows.
// SPDX-License-Identifier: MIT
#pragma once
#include "techniques/ray_tracing/ray_tree.h"
#include "techniques/technique.h"

namespace shadowlab::ray_tracing {

/// Adds a node for every ray of the tree, below each its shadow rays, parents before children; and as lines the secondary
/// rays that were followed, with the shadow rays of their ends to `light` (kNoLight: none).
void describeTree(const RayTree& tree, const Surfaces& surfaces, int light, Probe& probe);

} // namespace shadowlab::ray_tracing
