// Normals of smoothing groups (`s`): where a file gives no normals, faces of one group meet without an edge.
// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <span>
#include <unordered_map>
#include <vector>

#include "techniques/foundation/math/types.h"

namespace shadowlab::scene {

/// At each position the mean normal of the faces of one group that meet there, weighted by their areas: of whole polygons, so that it
/// does not matter into which triangles they are split. Positions with the same numbers are one, though the file may list them
/// several times, as it does along the seams of a texture.
class GroupNormals {
public:
    /// The positions must outlive this object.
    explicit GroupNormals(std::span<const dvec3> positions);

    /// A face, its corners as indices of positions in their order. Group 0 is no group.
    void add(std::uint32_t group, std::span<const std::uint32_t> corners);

    /// The unit normal of the group there; `fallback` where its faces cancel out, or for group 0.
    [[nodiscard]] vec3 at(std::uint32_t group, std::uint32_t corner, const vec3& fallback) const;

private:
    [[nodiscard]] std::uint64_t key(std::uint32_t group, std::uint32_t corner) const {
        return std::uint64_t{group} << 32 | place_[corner];
    }
    std::span<const dvec3> positions_;
    std::vector<std::uint32_t> place_; ///< of each position, the first one with the same numbers
    std::unordered_map<std::uint64_t, dvec3> sums_;
};

} // namespace shadowlab::scene
