// SPDX-License-Identifier: MIT
#include "techniques/foundation/scene/gltf/gltf_meshes.h"

#include <algorithm>

#include "techniques/foundation/scene/load/message_text.h"
#include "techniques/foundation/scene/model/holes.h"
#include "techniques/foundation/scene/obj/obj_mesh.h"
#include "techniques/foundation/scene/obj/vertex_welder.h"
#include "techniques/foundation/scene/query/topology/outward_parts.h"
#include "techniques/foundation/scene/query/topology/triangle_order.h"

namespace shadowlab::scene {

namespace {

/// Box of the positions that triangles use.
dvec3 originFor(const std::vector<GltfPrimitive>& primitives) {
    dvec3 lower(1e300), upper(-1e300);
    for (const GltfPrimitive& primitive : primitives)
        for (std::uint64_t t = 0; t < primitive.triangleCount(); ++t)
            for (const std::size_t vertex : primitive.triangle(t)) {
                const dvec3 position = primitive.position(vertex);
                lower = glm::min(lower, position);
                upper = glm::max(upper, position);
            }
    return chooseOrigin(lower, upper);
}

} // namespace

GltfMesh gltfMesh(const GltfParts& parts, std::size_t index, const std::vector<GltfPrimitive>& primitives, NormalMode mode) {
    std::uint64_t triangles = 0;
    bool hasColors = false, hasTexcoords = false;
    for (const GltfPrimitive& primitive : primitives) {
        triangles += primitive.triangleCount();
        hasColors |= primitive.hasColors();
        hasTexcoords |= primitive.hasTexcoords();
    }
    GltfMesh result;
    Mesh mesh;
    mesh.originObject = originFor(primitives);
    VertexWelder welder(3 * triangles);
    mesh.triangles.reserve(triangles);
    for (const GltfPrimitive& primitive : primitives) {
        MeshPart part{.materialName = "",
                      .firstTriangle = static_cast<std::uint32_t>(mesh.triangles.size()),
                      .triangleCount = 0,
                      .hasTexcoords = primitive.hasTexcoords()};
        if (primitive.material() >= 0) part.materialName = parts.materials[static_cast<std::size_t>(primitive.material())].material.name;
        for (std::uint64_t t = 0; t < primitive.triangleCount(); ++t) {
            const std::array<std::size_t, 3> vertices = primitive.triangle(t);
            std::array<vec3, 3> corners; // adding zero turns -0 into +0
            std::ranges::transform(vertices, corners.begin(),
                                   [&](std::size_t vertex) { return vec3(primitive.position(vertex) - mesh.originObject) + vec3(0.0f); });
            // Exact in double for all but absurd ratios of size: a triangle without area gives exactly zero.
            const dvec3 area = glm::cross(dvec3(corners[1]) - dvec3(corners[0]), dvec3(corners[2]) - dvec3(corners[0]));
            if (area == dvec3(0.0)) {
                ++mesh.droppedTriangles;
                continue;
            }
            const vec3 flat = vec3(glm::normalize(area)) + vec3(0.0f);
            uvec3 triangle;
            for (int i = 0; i < 3; ++i) {
                const std::size_t vertex = vertices[static_cast<std::size_t>(i)];
                const vec3 given = vec3(primitive.normal(vertex)) + vec3(0.0f);
                triangle[i] = welder.index({.position = corners[static_cast<std::size_t>(i)],
                                            .normal = given != vec3(0.0f) ? given : flat,
                                            .texcoord = primitive.texcoord(vertex),
                                            .color = hasColors ? primitive.color(vertex) : vec3(0.0f)});
            }
            mesh.triangles.push_back(triangle);
            ++part.triangleCount;
        }
        primitive.noteOddities();
        if (part.triangleCount == 0) continue;
        mesh.parts.push_back(part);
        result.materials.push_back(primitive.material());
    }
    if (mesh.droppedTriangles > 0) parts.source.note("meshes", index, "triangles without area are dropped", mesh.droppedTriangles);
    if (mesh.triangles.empty()) return result;
    mesh.positionsMesh = welder.of(&Vertex::position);
    mesh.normalsMesh = welder.of(&Vertex::normal);
    if (hasTexcoords) mesh.texcoords = welder.of(&Vertex::texcoord);
    if (hasColors) mesh.colors = welder.of(&Vertex::color);
    if (mode != NormalMode::file) mesh = withNormals(mesh, mode);
    keepNeighboursTogether(mesh);
    result.mesh = sharedMesh(std::move(mesh));
    return result;
}

} // namespace shadowlab::scene
