// The shadow volume as the lecture builds it: front faces as the top cap, back faces pushed away as the bottom cap, and quads
// from the edges between a front and a back face.
//
// Crow, "Shadow Algorithms for Computer Graphics", 1977. Right for closed meshes. An edge that does not join two faces is
// no outline here, so the volume of an open mesh has holes, and what is counted is wrong: volume.h does without that
// condition.
// SPDX-License-Identifier: MIT
#pragma once
#include "techniques/shadow_volume/count/volume.h"

namespace shadowlab::shadow_volume {

/// In place of buildVolume() (volume.h). A triangle with sign 0 counts as facing away: N.L > 0 it has not.
void buildLectureVolume(const scene::Mesh& mesh, const EdgeTable& edges, std::span<const std::int8_t> facing,
                        std::vector<SilhouetteEdge>& silhouette, Volume& volume);

} // namespace shadowlab::shadow_volume
