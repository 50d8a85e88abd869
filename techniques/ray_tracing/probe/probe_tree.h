// The tree of a pixel ray in words, numbers and lines: what `probe` prints, and drawings show.
// SPDX-License-Identifier: MIT
#pragma once
#include "techniques/ray_tracing/tree/ray_tree.h"
#include "techniques/technique.h"

namespace shadowlab::ray_tracing {

/// Adds a node for every ray of the tree, below each its shadow rays, parents before children. Surfaces are numbered S1,
/// S2 ... in the order of the tree, level by level; R1 and T1 are the rays that S1 sends on. The lines of the probe become
/// those of the rays that were followed, with the shadow rays of their ends to `light` (kNoLight: none); its vectors those
/// of the first surface.
void describeTree(const RayTree& tree, const Surfaces& surfaces, int light, Probe& probe);

} // namespace shadowlab::ray_tracing
