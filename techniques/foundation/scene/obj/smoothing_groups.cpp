// SPDX-License-Identifier: MIT
#include "techniques/foundation/scene/obj/smoothing_groups.h"

#include "techniques/foundation/scene/obj/vertex_welder.h"

namespace shadowlab::scene {

GroupNormals::GroupNormals(std::span<const vec3> positionsMesh) {
    VertexWelder byPosition(positionsMesh.size());
    place_.reserve(positionsMesh.size());
    for (const vec3& position : positionsMesh)
        place_.push_back(byPosition.index({.position = position}));
}

void GroupNormals::add(std::uint32_t group, std::span<const std::uint32_t, 3> corners, const dvec3& areaVectorMesh) {
    if (group == 0) return;
    for (const std::uint32_t corner : corners)
        sums_.try_emplace(key(group, corner), 0.0).first->second += areaVectorMesh;
}

vec3 GroupNormals::at(std::uint32_t group, std::uint32_t corner, const vec3& fallback) const {
    const auto found = group == 0 ? sums_.end() : sums_.find(key(group, corner));
    const double length = found == sums_.end() ? 0.0 : glm::length(found->second);
    return length > 0.0 ? vec3(found->second / length) + vec3(0.0f) : fallback; // -0 becomes +0
}

} // namespace shadowlab::scene
