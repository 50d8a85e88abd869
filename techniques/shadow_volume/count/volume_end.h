// Where a shadow volume ends: just beyond everything that could receive a shadow, since shorter sides are fewer pixels; or
// at infinity; or, as the lecture has it, a fixed distance behind the caster.
// SPDX-License-Identifier: MIT
#pragma once
#include <optional>

#include "techniques/foundation/scene/model/scene.h"

namespace shadowlab::shadow_volume {

/// Where a volume ends: at a plane, or at a distance; with neither, at infinity.
struct VolumeEnd {
    std::optional<dvec4> planeWorld; ///< dot(xyz, p) + w = 0 there, positive beyond
    std::optional<double>
        distance; ///< how far each vertex is pushed away from the light, metres; where there is no plane
};

/// The plane (dot(xyz, p) + w = 0, positive beyond) up to which to extrude a caster within `box`: of the six sides of a box
/// a little larger than that of the receivers, the one that the caster's shadow reaches soonest. No receiver lies beyond
/// it. Nothing if part of the caster or the light is beyond every side, or if some of the shadow would reach the plane only
/// after a very long way: then the volume ends at infinity.
std::optional<dvec4> endPlaneWorld(const scene::Bounds& box, const scene::Light& light, const scene::Bounds& receivers);

/// True when the shadow of what is in `box` certainly falls on nothing in the other box: the caster is beyond one of its
/// sides, and the light sends the shadow away from it.
bool missesAll(const scene::Bounds& box, const scene::Light& light, const scene::Bounds& receivers);

/// The point pushed away from the light to the end of the volume: what extrude.vert computes, in double. Homogeneous: w = 0
/// is a direction.
dvec4 pushedWorld(const dvec3& pointWorld, const scene::Light& light, const VolumeEnd& end);

} // namespace shadowlab::shadow_volume
