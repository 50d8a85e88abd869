// Normals of smoothing groups (`s`): where a file gives no normals, faces of one group meet without an edge.
// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <span>
#include <unordered_map>
#include <vector>

#include "techniques/foundation/math/types.h"

namespace shadowlab::scene {

/// At each position the mean normal of the triangles of one group that meet there, weighted by their areas. Positions with the same
/// numbers are one, though the file may list them several times, as it does along the seams of a texture.
class GroupNormals {
public:
    /// Mesh space. The positions must outlive this object.
    explicit GroupNormals(std::span<const vec3> positionsMesh);

    /// Corners are indices of positions. `areaVectorMesh`: perpendicular to the triangle, twice its area long. Group 0 is no group.
    void add(std::uint32_t group, std::span<const std::uint32_t, 3> corners, const dvec3& areaVectorMesh);

    /// The unit normal of the group there; `fallback` where its triangles cancel out, or for group 0.
    [[nodiscard]] vec3 at(std::uint32_t group, std::uint32_t corner, const vec3& fallback) const;

private:
    [[nodiscard]] std::uint64_t key(std::uint32_t group, std::uint32_t corner) const {
        return std::uint64_t{group} << 32 | place_[corner];
    }
    std::vector<std::uint32_t> place_; ///< of each position, the first one with the same numbers
    std::unordered_map<std::uint64_t, dvec3> sums_;
};

} // namespace shadowlab::scene
