// Moves the near plane out as far as the picture allows, which costs nothing and gains depth precision.
//
// With the far plane at infinity a depth buffer's step at distance z is z^2 / (near 2^bits): every doubling of `near`
// halves it, and with it the number of pixels in which two surfaces, or a surface and the side of a shadow volume,
// cannot be told apart.
// SPDX-License-Identifier: MIT
#pragma once
#include <span>

#include "techniques/foundation/scene/model/scene.h"

namespace shadowlab::scene {

/// The camera with its near plane moved out to just before the nearest thing in view; never nearer than it was. Nothing
/// that could be seen before is cut off. `bounds` are the scene's objectBounds, `aspect` is width over height.
Camera withTightNear(const Camera& camera, const Scene& scene, std::span<const Bounds> bounds, double aspect);

/// Metres along the eye's axis to the nearest point of a surface in view and beyond the camera's near plane; `most` if nothing is
/// nearer than that. Looks at every triangle, and works hard for those alone that come nearer than `most`.
double nearestInView(const Camera& camera, const Scene& scene, double aspect, double most);

/// Metres along the eye's axis just beyond the farthest corner of all boxes, which must not be cut off itself; twice `near` at least.
double farDepth(std::span<const Bounds> bounds, const dmat4& viewFromWorld, double near);

} // namespace shadowlab::scene
