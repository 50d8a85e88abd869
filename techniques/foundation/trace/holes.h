// Which triangles have holes, cut by an alpha mask, and whether a hit falls into one: the ray then goes on.
// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <vector>

#include "techniques/foundation/scene/model/scene.h"
#include "techniques/foundation/trace/world_triangles.h"

namespace shadowlab::trace {

class Holes {
public:
    /// None at all.
    Holes() = default;
    /// Scene and triangles must outlive it.
    Holes(const scene::Scene& scene, const WorldTriangles& world);

    /// Does a hit with these weights of the corners fall into a hole?
    bool operator()(std::uint32_t primitive, const dvec3& barycentric) const {
        return !perforated_.empty() && perforated_[primitive] && isInHole(primitive, barycentric);
    }
    [[nodiscard]] bool in(std::uint32_t primitive) const { return !perforated_.empty() && perforated_[primitive]; }
    /// One flag for each triangle; nullptr: no triangle has holes.
    [[nodiscard]] const std::uint8_t* flags() const { return perforated_.empty() ? nullptr : perforated_.data(); }

private:
    [[nodiscard]] bool isInHole(std::uint32_t primitive, const dvec3& barycentric) const;
    const scene::Scene* scene_ = nullptr;
    const WorldTriangles* world_ = nullptr;
    std::vector<std::uint8_t> perforated_;
};

} // namespace shadowlab::trace
