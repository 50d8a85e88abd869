// SPDX-License-Identifier: MIT
#include "techniques/shadow_map/exact/walk_buffers.h"

#include "techniques/foundation/scene/model/holes.h"

namespace shadowlab::shadow_map {

namespace {

/// Which corner of a triangle an edge follows: its own order is a -> b, or b -> a.
int cornerBefore(const uvec3& corners, const scene::Edge& edge, const std::vector<std::uint32_t>& welded) {
    for (int i = 0; i < 3; ++i) {
        const std::uint32_t from = welded[corners[i]], to = welded[corners[(i + 1) % 3]];
        if (std::min(from, to) == edge.a && std::max(from, to) == edge.b) return i;
    }
    return 0;
}

} // namespace

gl::TableTexture walkTriangles(const scene::Scene& scene, Topologies& topologies) {
    std::vector<uvec4> numbers;
    std::uint32_t firstVertex = 0;
    for (const scene::Object& object : scene.objects) {
        const auto firstTriangle = static_cast<std::uint32_t>(numbers.size() / 2);
        for (std::size_t p = 0; p < object.mesh->parts.size(); ++p) {
            const scene::MeshPart& part = object.mesh->parts[p];
            const std::uint32_t holes = scene::maskOfPart(scene, object, p) ? 1 : 0;
            for (std::uint32_t t = part.firstTriangle; t < part.firstTriangle + part.triangleCount; ++t) {
                numbers.emplace_back(object.mesh->triangles[t] + firstVertex, holes);
                numbers.emplace_back(kNoNeighbour);
            }
        }
        const scene::MeshTopology& topology = topologies.of(object.mesh);
        for (const scene::Edge& edge : topology.edges) {
            if (edge.useCount != 2) continue;
            const std::uint32_t pair[2] = {topology.uses[edge.firstUse].triangle,
                                           topology.uses[edge.firstUse + 1].triangle};
            for (int i = 0; i < 2; ++i) {
                const int corner = cornerBefore(object.mesh->triangles[pair[i]], edge, topology.welded);
                numbers[2 * (firstTriangle + pair[i]) + 1][corner] = firstTriangle + pair[1 - i];
            }
        }
        firstVertex += static_cast<std::uint32_t>(object.mesh->positionsMesh.size());
    }
    return {numbers, "triangles to walk over"};
}

gl::TableTexture walkPositions(const scene::Scene& scene, const LightMaps& maps) {
    std::vector<vec4> positions;
    for (const scene::Object& object : scene.objects) {
        const dmat4 lightRelative = lightRelativeFromMesh(maps, object);
        for (const vec3& positionMesh : object.mesh->positionsMesh)
            positions.emplace_back(lightRelative * dvec4(dvec3(positionMesh), 1.0));
    }
    return {positions, "positions to walk over"};
}

} // namespace shadowlab::shadow_map
