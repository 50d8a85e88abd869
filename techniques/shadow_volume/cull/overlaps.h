// How many volumes a point can be in at most: a stencil of eight bits counts to 255, and 256 would look like none.
//
// Seen from the light, the number of casting triangles in a direction changes only where a silhouette edge is crossed, and
// there by the edge's multiplicity. So walk from a direction in which there are none: what is crossed on the way bounds the
// number at its end. All ways lie in half planes through one axis, and going around it one counts the
// edges that reach into each. Silhouettes are short, so this takes little time beside building them.
// SPDX-License-Identifier: MIT
#pragma once
#include "techniques/shadow_volume/cull/casters.h"

namespace shadowlab::shadow_volume {

/// An upper bound, seldom much too large, of the number of triangles that count between the light and any point: of the
/// casters' top caps, their silhouettes as volume.h builds them.
int mostOverlaps(const scene::Scene& scene, const scene::Light& light, std::span<const CasterVolume> casters);

} // namespace shadowlab::shadow_volume
