// SPDX-License-Identifier: MIT
#include "techniques/foundation/scene/query/topology/mesh_topology.h"

#include <algorithm>
#include <bit>
#include <numeric>
#include <tuple>

#include "techniques/foundation/base/disjoint_sets.h"
#include "techniques/foundation/base/mixed_bits.h"

namespace shadowlab::scene {

namespace {

/// For each vertex, the first vertex at exactly the same place: found by a hash table with linear probing.
std::vector<std::uint32_t> weld(const std::vector<vec3>& positions) {
    constexpr std::uint32_t kEmpty = ~std::uint32_t{0};
    std::vector<std::uint32_t> slots(std::bit_ceil(2 * positions.size() + 1), kEmpty), representative(positions.size());
    for (std::uint32_t i = 0; i < positions.size(); ++i) {
        std::uint64_t hash = 0;
        for (int axis = 0; axis < 3; ++axis) {
            const auto bits = std::bit_cast<std::uint32_t>(positions[i][axis] + 0.0f); // -0 becomes 0, to which it is equal
            hash = hashedWith(hash, bits);
        }
        for (std::size_t at = hash;; ++at) {
            std::uint32_t& slot = slots[at & (slots.size() - 1)];
            if (slot == kEmpty) slot = i;
            if (slot != i && positions[slot] != positions[i]) continue;
            representative[i] = slot;
            break;
        }
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

std::vector<uvec3> weldedTriangles(const Mesh& mesh) {
    const std::vector<std::uint32_t> welded = weld(mesh.positionsMesh);
    std::vector<uvec3> triangles;
    triangles.reserve(mesh.triangles.size());
    for (const uvec3& corners : mesh.triangles)
        triangles.emplace_back(welded[corners.x], welded[corners.y], welded[corners.z]);
    return triangles;
}

MeshTopology buildTopology(const Mesh& mesh) {
    MeshTopology topology;
    topology.welded = weld(mesh.positionsMesh);

    // One record per triangle side, named by its undirected edge from a to b > a. They are put in the order of a by counting, and then
    // those of each a in the order of b, which brings the sides of one edge together.
    struct Side {
        std::uint32_t a, b;
        EdgeUse use;
    };
    std::vector<std::uint32_t> begins(mesh.positionsMesh.size() + 1, 0); // where the sides of each a begin
    const auto forEachSide = [&](const auto& visit) {
        for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t)
            for (int corner = 0; corner < 3; ++corner) {
                const std::uint32_t from = topology.welded[mesh.triangles[t][corner]];
                const std::uint32_t to = topology.welded[mesh.triangles[t][(corner + 1) % 3]];
                if (from == to) continue; // a side without length bounds nothing
                const auto direction = static_cast<std::int8_t>(from < to ? 1 : -1);
                visit(Side{std::min(from, to), std::max(from, to), {t, direction}});
            }
    };
    forEachSide([&](const Side& side) { ++begins[side.a + 1]; });
    std::partial_sum(begins.begin(), begins.end(), begins.begin());
    std::vector<Side> sides(begins.back());
    std::vector<std::uint32_t> next(begins.begin(), begins.end() - 1);
    forEachSide([&](const Side& side) { sides[next[side.a]++] = side; });
    for (std::size_t a = 0; a + 1 < begins.size(); ++a)
        std::sort(sides.begin() + begins[a], sides.begin() + begins[a + 1], [](const Side& x, const Side& y) {
            return std::tie(x.b, x.use.triangle, x.use.direction) < std::tie(y.b, y.use.triangle, y.use.direction);
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
    std::vector<bool> isUsed(mesh.positionsMesh.size(), false);
    for (const Edge& edge : topology.edges) {
        isUsed[edge.a] = isUsed[edge.b] = true;
        switch (kindOf(topology, edge)) {
        case EdgeKind::closed: break;
        case EdgeKind::boundary: ++report.boundaryEdges; break;
        case EdgeKind::multiple: ++report.multipleEdges; break;
        case EdgeKind::inconsistent: ++report.inconsistentEdges; break;
        }
    }
    report.weldedVertices = static_cast<std::uint64_t>(std::ranges::count(isUsed, true));
    return report;
}

} // namespace shadowlab::scene
