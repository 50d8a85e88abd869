// A triangle mesh as every technique sees it: the same floats on the CPU and on the GPU.
// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "techniques/foundation/math/types.h"

namespace shadowlab::scene {

/// A run of triangles that share one material.
struct MeshPart {
    std::string materialName; ///< as the file names it; empty: none given
    std::uint32_t firstTriangle = 0;
    std::uint32_t triangleCount = 0;
    bool hasTexcoords = false; ///< at every corner; else no image can be laid on it
};

/// A vertex of a mesh file that lies far from nearly all others (obj/outliers.h).
struct MeshOutlier {
    std::uint64_t vertex = 0, line = 0; ///< both counted from 1
    double distance = 0.0;              ///< to where the others are, in the units of the file
};

/// Immutable once built and shared between the objects that show it.
///
/// Positions are stored in *mesh space*: object space minus `originObject`, rounded to float once, when the mesh is made.
/// So a file whose coordinates are far from zero keeps its detail. These floats *are* the surface: the exact judge and the
/// graphics card use the same triangles.
struct Mesh {
    dvec3 originObject{0.0};            ///< positionObject = originObject + positionMesh
    std::vector<vec3> positionsMesh;    ///< one per vertex; equal positions have equal bits
    std::vector<vec3> normalsMesh;      ///< shading normals, unit, one per vertex
    std::vector<vec2> texcoords;        ///< (u, v) of an image laid on the mesh, one per vertex; empty: no part has any
    std::vector<vec3> colors;           ///< linear RGB, one per vertex; empty: the file has none
    std::vector<uvec3> triangles;       ///< vertex indices, counter-clockwise seen from the front
    std::vector<MeshPart> parts;        ///< in order, covering all triangles
    /// For each triangle its place in the file, where sorting by parts has changed the order; empty: they stand as the file has them.
    std::vector<std::uint32_t> fileOrder;
    std::uint32_t droppedTriangles = 0; ///< degenerate triangles of the source that were left out
    std::vector<MeshOutlier> outliers;  ///< of the file, the first few
    std::uint64_t outlierCount = 0;     ///< all of them
    /// No triangle has all its normals behind its front: the side that is seen says which way a normal is turned. Else they are turned to the eye.
    bool normalsOnFront = false;
    bool outward = false; ///< from outside, every back face is hidden by a front face (outward_parts.h); else not known
};

/// Index of the part that a triangle belongs to.
std::size_t partOf(const Mesh& mesh, std::uint32_t triangle);

} // namespace shadowlab::scene
