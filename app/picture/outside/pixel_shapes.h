// What a technique knows of one pixel as lines in the scene: its rays, and the vectors at the first surface.
// SPDX-License-Identifier: MIT
#pragma once
#include <vector>

#include "techniques/foundation/scene/model/camera.h"
#include "techniques/probe.h"

namespace shadowlab::picture {

/// One shape for each kind of ray, and what of the technique's structures the eye ray visits. The first rays of a tree bear
/// their names, R1, T1; vectors are arrows with a letter. Names and arrows are as large as `outside`, who looks on, has
/// to see them.
std::vector<SceneShape> pixelShapes(const Probe& probe, const scene::Camera& outside);

} // namespace shadowlab::picture
