// The flat faces of a scene: patches are cut from them, and they block light.
//
// Meshes consist of triangles, but walls, boxes and tables of rectangles. So two triangles of one object and material that share
// an edge, lie in one plane and form a convex quad together are one face.
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
    Plane plane;     ///< its plane
    std::array<std::uint32_t, 2> triangles; ///< numbers in the scene; a single triangle is listed twice
    std::uint32_t object = 0, material = 0;
    bool isFront = true; ///< false: of a side (sides.h) that is the back as the mesh has it, and no triangle's front
    bool shines = true; ///< false: of a side (sides.h) that stays dark though its material shines
};

struct Faces {
    std::vector<Face> all;
    std::vector<std::uint32_t> ofTriangle; ///< the face of each triangle of the scene
};

/// All of them, in the order of their first triangles.
Faces facesOf(const scene::Scene& scene, const trace::WorldTriangles& world);

} // namespace shadowlab::radiosity
