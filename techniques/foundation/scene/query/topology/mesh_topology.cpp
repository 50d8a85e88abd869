// SPDX-License-Identifier: MIT
#include "techniques/foundation/scene/query/topology/mesh_topology.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <tuple>
#include <unordered_set>

#include "techniques/foundation/base/disjoint_sets.h"

namespace shadowlab::scene {

namespace {

/// For each vertex, the first vertex at exactly the same place.
std::vector<std::uint32_t> weld(const std::vector<vec3>& positions) {
    std::vector<std::uint32_t> order(positions.size()), representative(positions.size());
    std::iota(order.begin(), order.end(), 0u);
    const auto key = [&](std::uint32_t i) { return std::array{positions[i].x, positions[i].y, positions[i].z}; };
    std::ranges::sort(order, [&](std::uint32_t i, std::uint32_t j) {
        const auto a = key(i), b = key(j);
        return a != b ? a < b : i < j;
    });
    for (std::size_t i = 0; i < order.size(); ++i) {
        const bool sameAsBefore = i > 0 && positions[order[i]] == positions[order[i - 1]];
        representative[order[i]] = sameAsBefore ? representative[order[i - 1]] : order[i];
    }
    return representative;
}

/// Triangles that repeat an earlier one. Each is counted at one edge only: that of its two lowest vertices.
std::uint64_t duplicateTriangles(const Mesh& mesh, const MeshTopology& topology) {
    std::uint64_t count = 0;
    std::vector<std::uint32_t> highest; // the third vertices at one edge
    for (const Edge& edge : topology.edges) {
        if (edge.useCount < 2) continue;
        highest.clear();
        for (std::uint32_t i = 0; i < edge.useCount; ++i) {
            const uvec3& corners = mesh.triangles[topology.uses[edge.firstUse + i].triangle];
            for (int corner = 0; corner < 3; ++corner)
                if (topology.welded[corners[corner]] > edge.b) highest.push_back(topology.welded[corners[corner]]);
        }
        std::ranges::sort(highest);
        for (std::size_t i = 1; i < highest.size(); ++i)
            if (highest[i] == highest[i - 1]) ++count;
    }
    return count;
}

/// The number of components connected by edges.
std::uint64_t components(const Mesh& mesh, const MeshTopology& topology) {
    DisjointSets joined(mesh.triangles.size());
    std::uint64_t count = mesh.triangles.size();
    for (const Edge& edge : topology.edges)
        for (std::uint32_t i = 1; i < edge.useCount; ++i)
            count -= joined.join(topology.uses[edge.firstUse].triangle, topology.uses[edge.firstUse + i].triangle) ? 1 : 0;
    return count;
}

} // namespace

MeshTopology buildTopology(const Mesh& mesh) {
    MeshTopology topology;
    topology.welded = weld(mesh.positionsMesh);

    // One record per triangle side, named by its undirected edge; sorting brings the sides of one edge together.
    struct Side {
        std::uint32_t a, b;
        EdgeUse use;
    };
    std::vector<Side> sides;
    sides.reserve(3 * mesh.triangles.size());
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
        for (int corner = 0; corner < 3; ++corner) {
            const std::uint32_t from = topology.welded[mesh.triangles[t][corner]];
            const std::uint32_t to = topology.welded[mesh.triangles[t][(corner + 1) % 3]];
            if (from == to) continue; // a side without length bounds nothing
            const bool forward = from < to;
            sides.push_back({std::min(from, to), std::max(from, to), {t, static_cast<std::int8_t>(forward ? 1 : -1)}});
        }
    }
    std::ranges::sort(sides, [](const Side& x, const Side& y) {
        return std::tie(x.a, x.b, x.use.triangle, x.use.direction) <
               std::tie(y.a, y.b, y.use.triangle, y.use.direction);
    });

    topology.uses.reserve(sides.size());
    for (const Side& side : sides) {
        if (topology.edges.empty() || topology.edges.back().a != side.a || topology.edges.back().b != side.b)
            topology.edges.push_back({side.a, side.b, static_cast<std::uint32_t>(topology.uses.size()), 0});
        ++topology.edges.back().useCount;
        topology.uses.push_back(side.use);
    }
    return topology;
}

EdgeKind kindOf(const MeshTopology& topology, const Edge& edge) {
    if (edge.useCount == 1) return EdgeKind::boundary;
    if (edge.useCount > 2) return EdgeKind::multiple;
    const EdgeUse* use = &topology.uses[edge.firstUse];
    return use[0].direction == use[1].direction ? EdgeKind::inconsistent : EdgeKind::closed;
}

MeshReport reportMesh(const Mesh& mesh, const MeshTopology& topology) {
    MeshReport report;
    report.triangles = mesh.triangles.size();
    report.droppedTriangles = mesh.droppedTriangles;
    report.duplicateTriangles = duplicateTriangles(mesh, topology);
    report.vertices = mesh.positionsMesh.size();
    report.components = components(mesh, topology);
    report.edges = topology.edges.size();
    std::unordered_set<std::uint32_t> vertices;
    for (const Edge& edge : topology.edges) {
        vertices.insert(edge.a);
        vertices.insert(edge.b);
        switch (kindOf(topology, edge)) {
        case EdgeKind::closed: break;
        case EdgeKind::boundary: ++report.boundaryEdges; break;
        case EdgeKind::multiple: ++report.multipleEdges; break;
        case EdgeKind::inconsistent: ++report.inconsistentEdges; break;
        }
    }
    report.weldedVertices = vertices.size();
    return report;
}

} // namespace shadowlab::scene
