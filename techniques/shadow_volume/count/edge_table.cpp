// SPDX-License-Identifier: MIT
#include "techniques/shadow_volume/count/edge_table.h"

namespace shadowlab::shadow_volume {

EdgeTable edgeTable(const scene::MeshTopology& topology) {
    EdgeTable table;
    table.ordinary.reserve(topology.edges.size());
    table.ends.reserve(topology.edges.size());
    for (const scene::Edge& edge : topology.edges) {
        const scene::EdgeUse* use = &topology.uses[edge.firstUse];
        if (kindOf(topology, edge) == scene::EdgeKind::closed) {
            const bool firstAlong = use[0].direction > 0;
            table.ordinary.push_back({use[firstAlong ? 0 : 1].triangle, use[firstAlong ? 1 : 0].triangle});
            table.ends.push_back({edge.a, edge.b});
        } else {
            const auto firstUse = static_cast<std::uint32_t>(table.uses.size());
            table.others.push_back(
                {static_cast<std::uint32_t>(table.ordinary.size()), {edge.a, edge.b, firstUse, edge.useCount}});
            table.uses.insert(table.uses.end(), use, use + edge.useCount);
        }
    }
    table.ordinary.shrink_to_fit();
    table.ends.shrink_to_fit();
    return table;
}

} // namespace shadowlab::shadow_volume
