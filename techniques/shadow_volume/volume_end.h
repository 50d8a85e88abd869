// Where a shadow volume may end: just beyond everything that could receive a shadow. Shorter sides are fewer pixels.
// SPDX-License-Identifier: MIT
#pragma once
#include <optional>

#include "techniques/foundation/scene/scene.h"

namespace shadowlab::shadow_volume {

/// The plane (dot(xyz, p) + w = 0, positive beyond) up to which to extrude a caster within `box`: of the six sides of a box
/// a little larger than the scene's, the one that the caster's shadow reaches soonest. Nothing lies beyond it. None where
/// the light is beyond every side, or parts of the shadow would reach it only after a very long way: that volume ends at
/// infinity.
std::optional<dvec4> endPlaneWorld(const scene::Bounds& box, const scene::Light& light,
                                   const scene::Bounds& sceneBounds);

/// Where the way from the light through a point meets the plane: what extrude.vert computes, in double.
dvec3 pushedToPlane(const dvec3& pointWorld, const scene::Light& light, const dvec4& planeWorld);

} // namespace shadowlab::shadow_volume
