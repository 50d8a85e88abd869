// SPDX-License-Identifier: MIT
#include "techniques/shadow_map/exact/loose_edges.h"

namespace shadowlab::shadow_map {

void forEachLooseEdge(const scene::MeshTopology& topology, std::span<const std::int8_t> facing,
                      const std::function<void(std::uint32_t a, std::uint32_t b)>& found) {
    for (const scene::Edge& edge : topology.edges) {
        // A triangle that runs a -> b and faces the light lies to the left of the edge; turn over one, and it is the right.
        int left = 0, right = 0;
        for (std::uint32_t u = edge.firstUse; u < edge.firstUse + edge.useCount; ++u) {
            const int side = topology.uses[u].direction * facing[topology.uses[u].triangle];
            left += side > 0;
            right += side < 0;
        }
        const bool goesOn = edge.useCount == 2 && left == 1 && right == 1;
        if (!goesOn) found(edge.a, edge.b);
    }
}

} // namespace shadowlab::shadow_map
