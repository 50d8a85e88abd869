// Motion for frame sequences: the lights, or the camera, on a circle about the camera's target.
// SPDX-License-Identifier: MIT
#pragma once
#include "techniques/foundation/scene/model/scene.h"

namespace shadowlab::film {

/// The scene with every light (positions, directions, edges, and the surfaces of area lights) turned by that angle
/// about the line through the camera's target along world +y.
scene::Snapshot withLightsTurned(const scene::Snapshot& snapshot, double degrees);

/// The camera turned about the same line.
scene::Camera turned(const scene::Camera& camera, double degrees);

} // namespace shadowlab::film
