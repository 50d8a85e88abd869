// An upper bound on the number of volumes around a point. A stencil of eight bits counts to 255; 256 volumes would look
// like none.
//
// Seen from the light, the number of casting triangles in a direction changes only where a silhouette edge is crossed, and
// there by the edge's multiplicity. So start at a direction with no triangle: the edges crossed on a path from there bound
// the number at its end. All paths lie in half planes through one axis; a sweep around the axis counts the edges in each
// half plane. Silhouettes have few edges, so this takes little time compared with finding them.
// SPDX-License-Identifier: MIT
#pragma once
#include "techniques/shadow_volume/cull/casters.h"

namespace shadowlab::shadow_volume {

/// An upper bound, seldom much too large, of the number of triangles that count between the light and any point: of the
/// casters' top caps, their silhouettes as volume.h builds them.
int mostOverlaps(const scene::Scene& scene, const scene::Light& light, std::span<const CasterVolume> casters);

} // namespace shadowlab::shadow_volume
