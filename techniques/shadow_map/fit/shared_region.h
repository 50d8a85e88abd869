// What casters and receivers have in common, as a directional light sees it.
// SPDX-License-Identifier: MIT
#pragma once
#include <span>

#include "techniques/shadow_map/fit/light_maps.h"

namespace shadowlab::shadow_map {

// The part of a map is rounded outward to so many steps: as long as the eye moves within a step, the map stays.
constexpr double kRegionSteps = 16;

/// Range of the boxes' corners in the light's view space.
Box boxInView(std::span<const scene::Bounds> boxes, const dvec3& originWorld, const dmat4& lightViewFromLightRelative);

Box around(const Box& a, const Box& b);

/// What of the receivers' boxes lies where the casters are, sideways; a floor that slants toward the light is much less deep
/// there than as a whole. Rounded outward, but not beyond the casters. Empty: nothing can be in shadow.
Box sharedRegion(const Box& casters, std::span<const scene::Bounds> receivers, const dvec3& originWorld,
                 const dmat4& lightViewFromLightRelative);

} // namespace shadowlab::shadow_map
