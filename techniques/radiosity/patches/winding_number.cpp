// SPDX-License-Identifier: MIT
#include "techniques/radiosity/patches/winding_number.h"

#include <algorithm>
#include <map>

#include "techniques/foundation/trace/bvh/bvh_traverse.h"

namespace shadowlab::radiosity {

bool ClosedBodies::contain(const dvec3& placeCentred, const dvec3& directionCentred) const {
    std::map<std::uint32_t, int> windings; ///< by body that the ray hits: few
    const auto isOfBody = [&](std::uint32_t triangle) { return isClosed_[world_.objects[triangle]]; };
    const auto count = [&](std::uint32_t triangle, const dvec3&) {
        windings[world_.objects[triangle]] += windingOf(world_.triangles[triangle], directionCentred);
        return true; // the ray goes on
    };
    (void)bvh_.any({placeCentred, directionCentred}, isOfBody, count);
    return std::ranges::any_of(windings, [](const auto& body) { return body.second != 0; });
}

} // namespace shadowlab::radiosity
