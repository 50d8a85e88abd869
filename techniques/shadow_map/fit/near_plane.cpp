// SPDX-License-Identifier: MIT
#include "techniques/shadow_map/fit/near_plane.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace shadowlab::shadow_map {

namespace {

// A step of the coarsest format, of 16 bits. What is twice as far from the near plane is kept as a step at least.
constexpr double kStep = 0x1p-16;

/// Has the box no corner before that layer's near plane?
bool isBeyondPlane(const LightMaps& maps, int layer, const scene::Bounds& box) {
    const dmat4 lightClipFromLightRelative = maps.lightClipFromLightRelative(layer);
    for (int i = 0; i < 8; ++i) {
        const dvec4 p = lightClipFromLightRelative * dvec4(box.corner(i) - maps.originWorld, 1.0);
        if (!(p.w > 0 && p.z >= (4 * kStep - 1) * p.w)) return false; // a depth of two steps, in -1..1
    }
    return true;
}

/// Is it farther from the light than all of that layer's near rectangle? What is in one of several maps may be beside another.
bool isBeyondRectangle(const LightMaps& maps, int layer, const scene::Bounds& box) {
    if (maps.parallel) return false;
    const dmat4& lightClip = maps.lightClipFromLightView[static_cast<std::size_t>(layer)];
    const dvec2 widest = (1.0 + glm::abs(dvec2(lightClip[2]))) / dvec2(lightClip[0][0], lightClip[1][1]);
    const double rim = maps.nearest * std::sqrt(1.0 + glm::dot(widest, widest));
    const dvec3 closest = glm::clamp(maps.originWorld, box.lowerWorld, box.upperWorld);
    return glm::length(closest - maps.originWorld) > 1.001 * rim; // a thousandth farther: many steps in depth
}

} // namespace

double leastReference(const LightMaps& maps, const scene::Bounds& objectWorld) {
    for (int layer = 0; layer < maps.layers(); ++layer)
        if (!isBeyondPlane(maps, layer, objectWorld) && !isBeyondRectangle(maps, layer, objectWorld))
            return -std::numeric_limits<float>::max();
    return kStep;
}

} // namespace shadowlab::shadow_map
