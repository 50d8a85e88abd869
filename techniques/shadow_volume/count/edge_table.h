// The edges of a mesh, stored for one fast pass over them per light.
//
// Nearly all edges of nearly all meshes join two triangles that are wound alike: such an edge is part of the silhouette
// where one of them faces the light and the other does not. The test needs two numbers per edge, which one array holds. The
// vertices of an edge are needed only if it is a silhouette, so another array holds them (fewer cache misses). Edges of any
// other kind are few; they are stored in a list of their own, with their place in the order. Edges are in the order of
// their lowest vertex, then the other: neighbours in the table are neighbours on the mesh, and so are their triangles.
// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "techniques/foundation/scene/query/topology/mesh_topology.h"

namespace shadowlab::shadow_volume {

struct EdgeTable {
    struct Ordinary {
        std::uint32_t along = 0, against = 0; ///< the triangle that runs a -> b, and the one that runs b -> a
    };
    struct Ends {
        std::uint32_t a = 0, b = 0; ///< vertex indices, a < b
    };
    struct Other {
        std::uint32_t ordinaryBefore = 0; ///< how many ordinary edges come before it
        scene::Edge edge;                 ///< with its uses in `uses`
    };
    std::vector<Ordinary> ordinary;
    std::vector<Ends> ends; ///< of each ordinary edge
    std::vector<Other> others;
    std::vector<scene::EdgeUse> uses;
};

EdgeTable edgeTable(const scene::MeshTopology& topology);

/// Calls found(a, b, sum, triangles) for each edge whose triangles do not cancel, in the order a, b. `sum` counts the
/// triangles turned toward the light that run a -> b along it, less those that run b -> a; it is not zero.
template <typename Found>
void forEachSilhouetteEdge(const EdgeTable& table, std::span<const std::int8_t> facing, const Found& found) {
    std::size_t next = 0;
    const auto ordinaryUpTo = [&](std::size_t end) {
        for (; next < end; ++next) {
            const int sum = facing[table.ordinary[next].along] - facing[table.ordinary[next].against];
            if (sum != 0) found(table.ends[next].a, table.ends[next].b, sum, 2u);
        }
    };
    for (const EdgeTable::Other& other : table.others) {
        ordinaryUpTo(other.ordinaryBefore);
        int sum = 0;
        for (std::uint32_t u = other.edge.firstUse; u < other.edge.firstUse + other.edge.useCount; ++u)
            sum += table.uses[u].direction * facing[table.uses[u].triangle];
        if (sum != 0) found(other.edge.a, other.edge.b, sum, other.edge.useCount);
    }
    ordinaryUpTo(table.ordinary.size());
}

} // namespace shadowlab::shadow_volume
