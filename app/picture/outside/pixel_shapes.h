// The probe of a pixel as lines in the scene: its rays, and the vectors at the first surface.
// SPDX-License-Identifier: MIT
#pragma once
#include <vector>

#include "app/picture/outside/thing_places.h"
#include "techniques/foundation/scene/model/camera.h"
#include "techniques/probe.h"

namespace shadowlab::picture {

/// One shape for each kind of ray, and what of the technique's structures the eye ray visits. Vectors are arrows, large enough to
/// be seen by the camera `outside`.
std::vector<SceneShape> pixelShapes(const Probe& probe, const scene::Camera& outside);

/// What vectors and the first rays of a tree are called, N, R1, T1, and where.
std::vector<NamedPoint> pixelNames(const Probe& probe, const scene::Camera& outside);

} // namespace shadowlab::picture
