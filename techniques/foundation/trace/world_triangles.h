// All triangles of a scene in one space, numbered through: the primitives that rays hit.
// SPDX-License-Identifier: MIT
#pragma once
#include <vector>

#include "techniques/foundation/scene/model/scene.h"
#include "techniques/foundation/trace/ray_triangle.h"

namespace shadowlab::trace {

/// Centred space: world axes, origin in the middle of the scene. The way there is composed in double before any vertex
/// goes it, so that triangles a million metres from the world's origin lose nothing.
struct WorldTriangles {
    dvec3 originWorld{0.0};
    std::vector<Triangle> triangles;          ///< of all objects, in their order: the facing signs have the same
    std::vector<std::uint32_t> objects;       ///< to which object each belongs
    std::vector<std::uint32_t> firstOfObject; ///< number of each object's first triangle
};

WorldTriangles worldTriangles(const scene::Scene& scene);

} // namespace shadowlab::trace
