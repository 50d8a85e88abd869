// The probe of a pixel as lines in the scene: its rays, and the vectors at the first surface.
// SPDX-License-Identifier: MIT
#pragma once
#include <vector>

#include "techniques/foundation/scene/model/camera.h"
#include "techniques/probe.h"

namespace shadowlab::picture {

/// One shape for each kind of ray, and what of the technique's structures the eye ray visits. The first rays of a tree have
/// their names beside them, R1, T1; vectors are arrows with a letter. Names and arrows are large enough to be seen by the camera
/// `outside`.
std::vector<SceneShape> pixelShapes(const Probe& probe, const scene::Camera& outside);

} // namespace shadowlab::picture
