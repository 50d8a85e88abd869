// SPDX-License-Identifier: MIT
#include "techniques/foundation/scene/obj/smoothing_groups.h"

#include "techniques/foundation/scene/obj/mesh_pieces.h"

namespace shadowlab::scene {

GroupNormals::GroupNormals(std::span<const dvec3> positions) : positions_(positions), place_(samePlaces(positions)) {}

void GroupNormals::add(std::uint32_t group, std::span<const std::uint32_t> corners) {
    if (group == 0) return;
    // Twice the area of the polygon, along its normal: the sum over a fan (M. Newell's formula is the same sum, about the origin).
    const auto fromFirst = [&](std::size_t i) { return positions_[corners[i]] - positions_[corners[0]]; };
    dvec3 areaVector(0.0);
    for (std::size_t i = 2; i < corners.size(); ++i)
        areaVector += glm::cross(fromFirst(i - 1), fromFirst(i));
    for (const std::uint32_t corner : corners)
        sums_.try_emplace(key(group, corner), 0.0).first->second += areaVector;
}

vec3 GroupNormals::at(std::uint32_t group, std::uint32_t corner, const vec3& fallback) const {
    const auto found = group == 0 ? sums_.end() : sums_.find(key(group, corner));
    const double length = found == sums_.end() ? 0.0 : glm::length(found->second);
    return length > 0.0 ? vec3(found->second / length) + vec3(0.0f) : fallback; // -0 becomes +0
}

} // namespace shadowlab::scene
