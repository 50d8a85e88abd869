// What stands before a map's near plane is kept at depth 0, "pancaked": all that is known of it is that it is nearer. Beside a
// point, a receiver's plane may seem to lie there, too, where light grazes it; a comparison with 0 would then say lit.
// SPDX-License-Identifier: MIT
#pragma once
#include "techniques/shadow_map/fit/light_maps.h"

namespace shadowlab::shadow_map {

/// The least depth that a point of an object compares. Where all of the object is beyond the near planes, more than 0: it has
/// left no 0 in any texel, whatever has is nearer. Else no bound: its own surface may be what is kept at 0.
double leastReference(const LightMaps& maps, const scene::Bounds& objectWorld);

} // namespace shadowlab::shadow_map
