// All triangles of a scene in one space, numbered consecutively: the primitives that rays hit, and the holes that alpha
// masks cut into them.
// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <vector>

#include "techniques/foundation/scene/model/scene.h"
#include "techniques/foundation/trace/ray_triangle.h"

namespace shadowlab::trace {

/// Centred space: world axes, origin in the middle of the scene. The matrix is composed in double before any vertex is
/// transformed, so that triangles a million metres from the world's origin lose no precision.
struct WorldTriangles {
    dvec3 originWorld{0.0};
    std::vector<Triangle> triangles;          ///< of all objects, in their order: the facing signs have the same
    std::vector<std::uint32_t> objects;       ///< to which object each belongs
    std::vector<std::uint32_t> firstOfObject; ///< number of each object's first triangle
    /// Its number in the mesh of its object.
    [[nodiscard]] std::uint32_t triangleInMesh(std::uint32_t primitive) const { return primitive - firstOfObject[objects[primitive]]; }
};

WorldTriangles worldTriangles(const scene::Scene& scene);

class Holes {
public:
    /// None at all.
    Holes() = default;
    /// Scene and triangles must outlive it.
    Holes(const scene::Scene& scene, const WorldTriangles& world);

    /// True if a hit with these weights of the corners falls into a hole: the ray then goes on.
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
