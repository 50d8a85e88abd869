// SPDX-License-Identifier: MIT
#include "techniques/foundation/scene/mesh_topology.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <tuple>
#include <unordered_set>

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

} // namespace

MeshTopology buildTopology(const Mesh& mesh) {
    const std::vector<std::uint32_t> welded = weld(mesh.positionsMesh);

    // One record per triangle side, named by its undirected edge; sorting brings the sides of one edge together.
    struct Side {
        std::uint32_t a, b;
        EdgeUse use;
    };
    std::vector<Side> sides;
    sides.reserve(3 * mesh.triangles.size());
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
        for (int corner = 0; corner < 3; ++corner) {
            const std::uint32_t from = welded[mesh.triangles[t][corner]];
            const std::uint32_t to = welded[mesh.triangles[t][(corner + 1) % 3]];
            if (from == to) continue; // a side without length bounds nothing
            const bool forward = from < to;
            sides.push_back({std::min(from, to), std::max(from, to), {t, static_cast<std::int8_t>(forward ? 1 : -1)}});
        }
    }
    std::ranges::sort(sides, [](const Side& x, const Side& y) {
        return std::tie(x.a, x.b, x.use.triangle, x.use.direction) <
               std::tie(y.a, y.b, y.use.triangle, y.use.direction);
    });

    MeshTopology topology;
    topology.uses.reserve(sides.size());
    for (const Side& side : sides) {
        if (topology.edges.empty() || topology.edges.back().a != side.a || topology.edges.back().b != side.b)
            topology.edges.push_back({side.a, side.b, static_cast<std::uint32_t>(topology.uses.size()), 0});
        ++topology.edges.back().useCount;
        topology.uses.push_back(side.use);
    }
    return topology;
}

MeshReport reportMesh(const Mesh& mesh, const MeshTopology& topology) {
    MeshReport report;
    report.triangles = mesh.triangles.size();
    report.edges = topology.edges.size();
    std::unordered_set<std::uint32_t> vertices;
    for (const Edge& edge : topology.edges) {
        vertices.insert(edge.a);
        vertices.insert(edge.b);
        if (edge.useCount == 1) ++report.boundaryEdges;
        if (edge.useCount > 2) ++report.multipleEdges;
        const EdgeUse* use = &topology.uses[edge.firstUse];
        if (edge.useCount == 2 && use[0].direction == use[1].direction) ++report.inconsistentEdges;
    }
    report.weldedVertices = vertices.size();
    return report;
}

} // namespace shadowlab::scene
