// The flat faces of a scene: what patches are cut from, and what stands between them.
//
// Meshes are triangles, but walls, boxes and tables are rectangles: two triangles of one object and material that share an
// edge, lie in one plane and make a convex quad together are one face.
// SPDX-License-Identifier: MIT
#pragma once
#include <vector>

#include "techniques/foundation/scene/model/scene.h"
#include "techniques/foundation/trace/world_triangles.h"
#include "techniques/radiosity/patches/polygon.h"

namespace shadowlab::radiosity {

constexpr std::uint32_t kNoFace = ~std::uint32_t{0};

struct Face {
    Polygon polygon; ///< centred space (world_triangles.h), counter-clockwise seen from the front
    Plane plane;     ///< that it lies in
    std::array<std::uint32_t, 2> triangles; ///< of the scene; of a lone triangle the same twice
    std::uint32_t object = 0, material = 0;
};

struct Faces {
    std::vector<Face> all;
    std::vector<std::uint32_t> ofTriangle; ///< which face each triangle of the scene belongs to
};

/// All of them, in the order of their first triangles.
Faces facesOf(const scene::Scene& scene, const trace::WorldTriangles& world);

} // namespace shadowlab::radiosity
