// The near plane of a scene whose camera names none.
// SPDX-License-Identifier: MIT
#pragma once
#include "techniques/foundation/scene/model/scene.h"

namespace shadowlab::scene {

/// For a camera in that scene, whose own near plane does not matter: 0.1 m, and less where the scene asks for it:
/// - at most a tenth of the way from the eye to its target, so that a camera that orbits a small thing cuts none of it off;
/// - where a surface in view is nearer than 0.1 m, a tenth of its distance, so that the camera may still come closer. But not
///   less than a hundredth of the way to the target, or 1 cm: a surface that reaches to the eye is cut somewhere, and behind it
///   depths would become coarse (z^2 / (near 2^24): 0.6 mm at 10 m).
/// Elsewhere a small distance costs no precision: techniques draw with the near plane moved out to what is in view (depth_fit.h).
double defaultNear(const Scene& scene, Camera camera);

} // namespace shadowlab::scene
