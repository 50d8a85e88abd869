// SPDX-License-Identifier: MIT
#include "techniques/foundation/trace/area/surface_edges.h"

#include "techniques/foundation/scene/query/topology/mesh_topology.h"

namespace shadowlab::trace {

SurfaceEdges::SurfaceEdges(const scene::Scene& scene, const WorldTriangles& world)
    : ofPrimitive_(world.triangles.size()) {
    for (std::size_t o = 0; o < scene.objects.size(); ++o) {
        const scene::Mesh& mesh = *scene.objects[o].mesh;
        const scene::MeshTopology topology = scene::buildTopology(mesh);
        const std::uint32_t firstPrimitive = world.firstOfObject[o];
        for (const scene::Edge& edge : topology.edges) {
            Edge added;
            added.firstUse = static_cast<std::uint32_t>(uses_.size());
            added.useCount = edge.useCount;
            for (std::uint32_t u = edge.firstUse; u < edge.firstUse + edge.useCount; ++u) {
                const scene::EdgeUse& use = topology.uses[u];
                const std::uint32_t primitive = firstPrimitive + use.triangle;
                const uvec3& corners = mesh.triangles[use.triangle];
                const Triangle& triangle = world.triangles[primitive];
                const std::array<const dvec3*, 3> positions = {&triangle.a, &triangle.b, &triangle.c};
                for (std::size_t corner = 0; corner < 3; ++corner) {
                    const std::size_t next = (corner + 1) % 3;
                    const std::uint32_t from = topology.welded[corners[static_cast<int>(corner)]];
                    const std::uint32_t to = topology.welded[corners[static_cast<int>(next)]];
                    const bool forward = from == edge.a && to == edge.b;
                    if (!forward && !(from == edge.b && to == edge.a)) continue;
                    ofPrimitive_[primitive][corner] = static_cast<std::uint32_t>(edges_.size());
                    added.firstCentred = *positions[forward ? corner : next];
                    added.secondCentred = *positions[forward ? next : corner];
                }
                uses_.push_back({primitive, use.direction});
            }
            edges_.push_back(added);
        }
    }
}

} // namespace shadowlab::trace
