// SPDX-License-Identifier: MIT
#include "techniques/shadow_volume/volume.h"

#include <cstdlib>

namespace shadowlab::shadow_volume {

std::vector<SilhouetteEdge> silhouetteEdges(const scene::MeshTopology& topology, std::span<const std::int8_t> facing) {
    std::vector<SilhouetteEdge> silhouette;
    for (const scene::Edge& edge : topology.edges) {
        // Each triangle, turned toward the light, runs along the edge one way or the other; opposite ways cancel.
        int sum = 0;
        for (std::uint32_t u = edge.firstUse; u < edge.firstUse + edge.useCount; ++u)
            sum += topology.uses[u].direction * facing[topology.uses[u].triangle];
        if (sum == 0) continue;
        const auto multiplicity = static_cast<std::uint32_t>(std::abs(sum));
        silhouette.push_back(sum > 0 ? SilhouetteEdge{edge.a, edge.b, multiplicity, edge.useCount}
                                     : SilhouetteEdge{edge.b, edge.a, multiplicity, edge.useCount});
    }
    return silhouette;
}

Volume buildVolume(const scene::Mesh& mesh, std::span<const std::int8_t> facing,
                   std::span<const SilhouetteEdge> silhouette) {
    Volume volume;
    const auto far = static_cast<std::uint32_t>(mesh.positionsMesh.size());

    // Caps. The top cap keeps the order in which the mesh itself is drawn: with another order the rasteriser's depth
    // may differ in the last bit and the cap would fight with the very surface it lies on.
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        if (facing[t] == 0) continue;
        const uvec3& corner = mesh.triangles[t];
        std::vector<std::uint32_t>& top = facing[t] > 0 ? volume.topCap : volume.topCapReversed;
        top.insert(top.end(), {corner.x, corner.y, corner.z});
        const std::uint32_t second = facing[t] > 0 ? corner.z : corner.y; // the bottom looks the other way
        const std::uint32_t third = facing[t] > 0 ? corner.y : corner.z;
        volume.bottomCap.insert(volume.bottomCap.end(), {corner.x + far, second + far, third + far});
    }

    // Sides. The cap runs a -> b, so the side that joins it there runs b -> a, and where it joins the bottom cap a -> b.
    for (const SilhouetteEdge& edge : silhouette) {
        const std::uint32_t farA = edge.a + far, farB = edge.b + far;
        for (std::uint32_t i = 0; i < edge.multiplicity; ++i)
            volume.sides.insert(volume.sides.end(), {edge.b, edge.a, farA, edge.b, farA, farB});
    }
    return volume;
}

} // namespace shadowlab::shadow_volume
