// Shading normals made from the triangles alone: flat, one per triangle, or smooth, one per position.
// SPDX-License-Identifier: MIT
#include <vector>

#include "techniques/foundation/scene/model/shapes.h"
#include "techniques/foundation/scene/obj/vertex_welder.h"

namespace shadowlab::scene {

namespace {

/// Perpendicular to the triangle, twice as long as its area; in double, so that neither tiny nor huge meshes underflow
/// or overflow when lengths are squared.
dvec3 areaVector(const Mesh& mesh, const uvec3& triangle) {
    const dvec3 a(mesh.positionsMesh[triangle.x]), b(mesh.positionsMesh[triangle.y]), c(mesh.positionsMesh[triangle.z]);
    return glm::cross(b - a, c - a);
}

/// Normalised, in float. A triangle without area has no direction; any unit vector is better than NaN.
vec3 unitOr(const dvec3& v, const vec3& fallback) {
    const double length = glm::length(v);
    return length > 0.0 ? vec3(v / length) + vec3(0.0f) : fallback;
}

/// One vertex per corner, with the normal that `normalOf(triangle, corner)` gives; equal ones are merged. Texture
/// coordinates and colours stay as they are.
template <typename NormalOf>
Mesh rebuilt(const Mesh& mesh, const NormalOf& normalOf) {
    Mesh result = mesh;
    VertexWelder welder(3 * mesh.triangles.size());
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
        for (int corner = 0; corner < 3; ++corner) {
            const std::uint32_t vertex = mesh.triangles[t][corner];
            result.triangles[t][corner] =
                welder.index({.position = mesh.positionsMesh[vertex] + vec3(0.0f),
                              .normal = normalOf(t, corner),
                              .texcoord = mesh.texcoords.empty() ? vec2(0.0f) : mesh.texcoords[vertex],
                              .color = mesh.colors.empty() ? vec3(0.0f) : mesh.colors[vertex]});
        }
    result.positionsMesh = welder.of(&Vertex::position);
    result.normalsMesh = welder.of(&Vertex::normal);
    if (!mesh.texcoords.empty()) result.texcoords = welder.of(&Vertex::texcoord);
    if (!mesh.colors.empty()) result.colors = welder.of(&Vertex::color);
    return result;
}

Mesh withFlatNormals(const Mesh& mesh) {
    return rebuilt(
        mesh, [&](std::size_t t, int) { return unitOr(areaVector(mesh, mesh.triangles[t]), vec3(0.0f, 1.0f, 0.0f)); });
}

Mesh withSmoothNormals(const Mesh& mesh) {
    // Vertices that share a position share a normal, whatever normals they had before.
    VertexWelder byPosition(mesh.positionsMesh.size());
    std::vector<std::uint32_t> place(mesh.positionsMesh.size());
    for (std::size_t i = 0; i < place.size(); ++i)
        place[i] = byPosition.index({.position = mesh.positionsMesh[i] + vec3(0.0f)});

    // The area vector of a triangle is already weighted by its area.
    std::vector<dvec3> sums(place.size(), dvec3(0.0));
    for (const uvec3& triangle : mesh.triangles)
        for (int corner = 0; corner < 3; ++corner)
            sums[place[triangle[corner]]] += areaVector(mesh, triangle);

    return rebuilt(mesh, [&](std::size_t t, int corner) {
        const vec3 flat = unitOr(areaVector(mesh, mesh.triangles[t]), vec3(0.0f, 1.0f, 0.0f));
        return unitOr(sums[place[mesh.triangles[t][corner]]], flat);
    });
}

} // namespace

Mesh withNormals(const Mesh& mesh, NormalMode mode) {
    switch (mode) {
    case NormalMode::flat: return withFlatNormals(mesh);
    case NormalMode::smooth: return withSmoothNormals(mesh);
    case NormalMode::file: return mesh;
    }
    return mesh;
}

} // namespace shadowlab::scene
