// What a second camera sees besides the objects, whatever the technique: the eye with its view, and the lights.
// SPDX-License-Identifier: MIT
#pragma once
#include <vector>

#include "techniques/technique.h"

namespace shadowlab::picture {

/// Depth, in metres along the eye's axis, to which its view is drawn: a little beyond the farthest thing in it. Floors
/// that reach to the horizon do not count (scene::thingsBounds).
double shownDepth(const scene::Scene& scene, const View& eye);

/// What the eye sees: the edges of its view from the eye itself to shownDepth(), closed there by a rectangle; and the one at its
/// near plane.
std::vector<SceneShape> eyeShapes(const scene::Scene& scene, const View& eye);

/// A sign for every light, as large as it has to be to be seen by the camera: a star for a point, arrows for a direction,
/// a cone for a spot; the outline of a rect and a sphere, in their own size. `light` in the colour of the light that is
/// looked at (kNoLight: none), which comes last, all others grey. `things` are the scene's thingsBounds.
std::vector<SceneShape> lightShapes(const scene::Scene& scene, const scene::Bounds& things, int light,
                                    const scene::Camera& outside);

} // namespace shadowlab::picture
