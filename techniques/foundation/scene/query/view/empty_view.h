// Why a picture shows no surface, and what would change that.
// SPDX-License-Identifier: MIT
#pragma once
#include <string>

#include "techniques/foundation/scene/model/scene.h"

namespace shadowlab::scene {

/// "all 3 objects lie behind the camera; turn it round, ...": for a picture of `size` samples in which no surface covers the
/// centre of any; empty where one does. Of a scene in view it looks at few triangles. Simplified: holes count as surface.
std::string whyNothingIsSeen(const Scene& scene, const Camera& camera, ivec2 size);

} // namespace shadowlab::scene
