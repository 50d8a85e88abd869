// Where the triangles of a mesh lie on a coarser one that stands for it.
// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "techniques/radiosity/simplify/vertex_clusters.h"

namespace shadowlab::radiosity {

/// A place on a triangle.
struct SurfacePlace {
    std::uint32_t triangle = 0;     ///< scene-wide number, as in trace::worldTriangles
    std::array<float, 3> weights{}; ///< of its corners; they sum to 1
    friend bool operator==(const SurfacePlace&, const SurfacePlace&) = default;
};

/// The three corners of every original triangle: for each the nearest place on the coarse triangles that end in its cell, or share
/// a corner with one that does, and face the same way; if it can be on one of the same part. Where none faces the same way, on any
/// of the mesh that does, and where there is none, on one that does not. `coarse` has at least one triangle, and `firstTriangle`
/// is the number of its first.
std::vector<std::array<SurfacePlace, 3>> cornerPlaces(const scene::Mesh& original, const VertexClusters& clusters,
                                                      const ClusteredMesh& coarse, std::uint32_t firstTriangle);

} // namespace shadowlab::radiosity
