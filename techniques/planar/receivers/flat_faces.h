// The flat faces of a mesh: what a planar shadow can fall on.
//
// A face is a set of triangles that are connected by edges and lie in one plane: the two of a quad, the two of a side of a
// box, the many of a tiled floor. Its shading normals have to be those of the plane, and it must not be a facet of a curved
// surface: it is large compared with the mesh, or bounded by sharp edges.
// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "techniques/foundation/scene/model/mesh.h"

namespace shadowlab::planar {

/// Consecutive triangles of a mesh.
struct TriangleRun {
    std::uint32_t first = 0, count = 0;
};

/// Triangle indices, each larger than the one before, as runs.
std::vector<TriangleRun> runsOf(const std::vector<std::uint32_t>& ascending);

bool contains(const std::vector<TriangleRun>& runs, std::uint32_t triangle);

struct FlatFace {
    dvec3 pointMesh{0.0};  ///< a point of the plane
    dvec3 normalMesh{0.0}; ///< unit; the front of the largest triangle
    double unevenness = 0; ///< largest distance of a corner from the plane, in units of mesh space: rounding only
    std::vector<TriangleRun> runs;
    std::vector<std::array<dvec3, 2>> outlineMesh; ///< the edges of its outline
    std::array<dvec3, 4> frameMesh{}; ///< corners, in order, of a rectangle in the plane that holds the face
};

/// The flat faces of a mesh, and why the rest of its area is not in them.
struct FlatFaces {
    std::vector<FlatFace> faces; ///< in the order of their first triangles
    double area = 0;             ///< of the whole mesh, in units of mesh space; the rest are parts of it
    double smoothArea = 0;       ///< shading normals are not those of the triangles
    double facetArea = 0;        ///< small, and its outline bends gently: a facet of something curved
    double leftOverArea = 0;     ///< of faces beyond the 2048 largest
};

/// O(n log n) in the triangles that are shaded flat.
FlatFaces flatFaces(const scene::Mesh& mesh);

} // namespace shadowlab::planar
