// Maps the triangles of a mesh onto its simplified version.
// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "techniques/radiosity/simplify/vertex_clusters.h"

namespace shadowlab::radiosity {

/// A point on a triangle.
struct SurfacePlace {
    std::uint32_t triangle = 0;     ///< counted through the whole scene, as in trace::worldTriangles
    std::array<float, 3> weights{}; ///< of its corners; they sum to 1
    friend bool operator==(const SurfacePlace&, const SurfacePlace&) = default;
};

/// The places of the three corners of every original triangle: the nearest on the coarse triangles in or around its cell that
/// face the same way, if possible on one of the same part. If none there faces the same way, on any of the mesh that does; if
/// none does, on one that does not. `coarse` has at least one triangle; `firstTriangle` is the number of its first.
std::vector<std::array<SurfacePlace, 3>> cornerPlaces(const scene::Mesh& original, const VertexClusters& clusters,
                                                      const ClusteredMesh& coarse, std::uint32_t firstTriangle);

} // namespace shadowlab::radiosity
