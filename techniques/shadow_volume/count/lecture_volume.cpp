// SPDX-License-Identifier: MIT
#include "techniques/shadow_volume/count/volume.h"

namespace shadowlab::shadow_volume {

namespace {

/// An edge of two triangles: `first` runs a -> b along it if `firstAlong`, `second` if `secondAlong`.
struct Shared {
    std::uint32_t a = 0, b = 0;
    std::uint32_t first = 0, second = 0; ///< triangles
    bool firstAlong = true, secondAlong = false;
};

template <typename Visit>
void forEachSharedEdge(const EdgeTable& edges, const Visit& visit) {
    for (std::size_t i = 0; i < edges.ordinary.size(); ++i)
        visit({edges.ends[i].a, edges.ends[i].b, edges.ordinary[i].along, edges.ordinary[i].against, true, false});
    for (const EdgeTable::Other& other : edges.others)
        if (other.edge.useCount == 2) { // two faces that are wound against each other
            const scene::EdgeUse &first = edges.uses[other.edge.firstUse],
                                 &second = edges.uses[other.edge.firstUse + 1];
            visit({other.edge.a, other.edge.b, first.triangle, second.triangle, first.direction > 0,
                   second.direction > 0});
        }
}

} // namespace

void buildLectureVolume(const scene::Mesh& mesh, const EdgeTable& edges, std::span<const std::int8_t> facing,
                        std::vector<SilhouetteEdge>& silhouette, Volume& volume) {
    silhouette.clear();
    volume = {};
    const auto far = static_cast<std::uint32_t>(mesh.positionsMesh.size());
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        const uvec3& corner = mesh.triangles[t];
        if (facing[t] > 0)
            volume.topCap.insert(volume.topCap.end(), {corner.x, corner.y, corner.z});
        else
            volume.bottomCap.insert(volume.bottomCap.end(), {corner.x + far, corner.y + far, corner.z + far});
    }
    forEachSharedEdge(edges, [&](const Shared& edge) {
        const bool firstIsFront = facing[edge.first] > 0, secondIsFront = facing[edge.second] > 0;
        if (firstIsFront == secondIsFront) return;
        const bool along = firstIsFront ? edge.firstAlong : edge.secondAlong;
        const std::uint32_t a = along ? edge.a : edge.b, b = along ? edge.b : edge.a;
        silhouette.push_back({a, b, 1, 2});
        volume.sides.insert(volume.sides.end(), {b, a, a + far});
    });
    for (const SilhouetteEdge& edge : silhouette)
        volume.sides.insert(volume.sides.end(), {edge.b, edge.a + far, edge.b + far});
}

} // namespace shadowlab::shadow_volume
