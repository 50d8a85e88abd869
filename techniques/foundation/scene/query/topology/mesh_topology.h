// Which triangles meet at which edges, for any set of triangles: closed, open, non-manifold, inconsistently wound.
// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <vector>

#include "techniques/foundation/scene/model/mesh.h"

namespace shadowlab::scene {

/// An undirected edge between two welded vertices (the first vertex with that exact position stands for all).
struct Edge {
    std::uint32_t a = 0, b = 0; ///< vertex indices, a < b
    std::uint32_t firstUse = 0, useCount = 0;
};

/// One triangle at an edge. `direction` is +1 where the triangle's corner order runs a -> b, -1 where it runs b -> a.
struct EdgeUse {
    std::uint32_t triangle = 0;
    std::int8_t direction = 0;
};

struct MeshTopology {
    std::vector<Edge> edges;
    std::vector<EdgeUse> uses;         ///< those of edge e: uses[e.firstUse] ... e.useCount of them
    std::vector<std::uint32_t> welded; ///< of each vertex, the vertex that stands for it
};

/// Welds vertices by exact position and collects every edge with all its triangles. O(n), but where very many edges meet in a vertex.
MeshTopology buildTopology(const Mesh& mesh);

/// The mesh's triangles, of the vertices that stand for theirs.
std::vector<uvec3> weldedTriangles(const Mesh& mesh);

/// What an edge says about the surface there.
enum class EdgeKind {
    closed,       ///< two triangles, wound alike
    boundary,     ///< one triangle: the mesh is open there
    multiple,     ///< more than two triangles
    inconsistent, ///< two triangles that run the same way: windings disagree
};
EdgeKind kindOf(const MeshTopology& topology, const Edge& edge);

/// What a mesh is made of.
struct MeshReport {
    std::uint64_t triangles = 0;
    std::uint64_t droppedTriangles = 0;   ///< degenerate ones of the source, left out when it was loaded
    std::uint64_t duplicateTriangles = 0; ///< those with the same three welded vertices as an earlier one, in any order
    std::uint64_t vertices = 0;           ///< of the buffers; several may lie at one place, with different normals
    std::uint64_t weldedVertices = 0, edges = 0;
    std::uint64_t boundaryEdges = 0; ///< how many of each kind
    std::uint64_t multipleEdges = 0;
    std::uint64_t inconsistentEdges = 0;
    std::uint64_t components = 0; ///< components connected by edges (a common vertex is not enough)
    bool hasHoles = false; ///< set for an object: an alpha map cuts holes (scene/model/holes.h); the mesh itself has no such information
    [[nodiscard]] bool isClosed() const { return boundaryEdges == 0 && multipleEdges == 0 && inconsistentEdges == 0; }
};
MeshReport reportMesh(const Mesh& mesh, const MeshTopology& topology);

} // namespace shadowlab::scene
