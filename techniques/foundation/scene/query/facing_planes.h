// The facing signs of a whole mesh, with SIMD: the planes of the triangles are stored in arrays, and several are tested at
// once.
//
// The side of a plane that a point is on is one scalar product. If the product is clearly not zero, its sign is that of
// facing.h; otherwise facing.h decides. So all signs are equal to those of facing.h. Only triangles seen almost exactly
// edge-on are in doubt.
// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "techniques/foundation/scene/model/mesh.h"

namespace shadowlab::scene {

/// Made once per mesh, asked once per light and move.
class FacingPlanes {
public:
    explicit FacingPlanes(std::shared_ptr<const Mesh> mesh);

    /// One sign per triangle: what facingSigns (facing.h) finds for a light at this homogeneous point of mesh space,
    /// of a rect light before clearInLampPlane (lamp_plane.h).
    /// `signs` is as long as the mesh has triangles.
    void findSigns(const dvec4& lightMesh, std::span<std::int8_t> signs) const;

    [[nodiscard]] std::size_t size() const { return x_.size(); }
    /// The planes' coordinates (x, y, z, w), one array for each.
    [[nodiscard]] std::span<const double> coordinates(int i) const {
        return i == 0 ? x_ : i == 1 ? y_ : i == 2 ? z_ : w_;
    }

private:
    std::shared_ptr<const Mesh> mesh_;
    std::vector<double> x_, y_, z_, w_; ///< in front: dot(xyz, p) + w > 0; xyz of size 1 or less
    double farthest_ = 0;               ///< of all vertices: the largest sum of coordinates without signs
};

} // namespace shadowlab::scene
