// How far from an edge of the truth a shadow map may be wrong: the reach of its texels, as the eye sees them.
// SPDX-License-Identifier: MIT
#pragma once
#include "tests/support/truth_comparison.h"

namespace shadowlab::testing {

/// max(1.5 px, `texels` projected texels): a texel, seen from the light, covers texel / cos(angle to the light) of a
/// surface; seen from the eye that is at most so many pixels.
TieRadius edgeReach(const scene::Snapshot& snapshot, int light, int resolution, ivec2 size, double texels);

} // namespace shadowlab::testing
