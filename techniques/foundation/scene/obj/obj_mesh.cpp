// The steps from polygons to a mesh, in the order of buildMesh at the end.
// SPDX-License-Identifier: MIT
#include "techniques/foundation/scene/obj/obj_mesh.h"

#include <algorithm>
#include <cmath>

#include "techniques/foundation/scene/obj/polygon_triangulation.h"
#include "techniques/foundation/scene/obj/smoothing_groups.h"
#include "techniques/foundation/scene/obj/vertex_welder.h"

namespace shadowlab::scene {

namespace {

struct CornerTriangle {
    std::array<std::uint32_t, 3> corners; ///< indices into ObjFaces::corners
    std::uint32_t material, group;
    bool hasTexcoords;   ///< at all three corners
    std::uint32_t place; ///< among the triangles of the file
};

/// Box of the positions that faces use: an unused vertex far away must not determine the origin.
dvec3 originOf(const ObjScan& scan, const ObjFaces& faces) {
    dvec3 lower(1e300), upper(-1e300);
    for (const ObjCorner& corner : faces.corners) {
        lower = glm::min(lower, scan.positions[corner.position]);
        upper = glm::max(upper, scan.positions[corner.position]);
    }
    return chooseOrigin(lower, upper);
}

/// Rounds each position once; adding zero turns -0 into +0, so that equal positions have equal bits.
std::vector<vec3> roundedPositions(const std::vector<dvec3>& positions, const dvec3& origin) {
    std::vector<vec3> result;
    result.reserve(positions.size());
    for (const dvec3& position : positions)
        result.push_back(vec3(position - origin) + vec3(0.0f));
    return result;
}

bool hasTexcoord(const ObjScan& scan, const ObjCorner& corner) {
    return corner.texcoord >= 0 && std::isfinite(scan.texcoords[corner.texcoord].x + scan.texcoords[corner.texcoord].y);
}

/// Perpendicular to the triangle, with twice its area as length; the difference of floats and its products are exact
/// in double for all but absurd ratios of size, so a straight triangle gives exactly zero.
dvec3 areaVectorOf(const vec3& a, const vec3& b, const vec3& c) {
    return glm::cross(dvec3(b) - dvec3(a), dvec3(c) - dvec3(a));
}

std::uint32_t groupOf(const ObjScan& scan, std::size_t face) {
    return scan.smoothingGroups.empty() ? 0 : scan.smoothingGroups[face];
}

/// All polygons split; triangles that have no area once rounded are counted, not kept.
std::vector<CornerTriangle> split(const ObjScan& scan, const ObjFaces& faces, const std::vector<vec3>& rounded,
                                  std::uint32_t& dropped) {
    std::vector<CornerTriangle> result;
    result.reserve(faces.corners.size() - 2 * faces.materialOf.size());
    std::vector<dvec3> polygon;
    std::vector<std::array<std::uint32_t, 3>> triangles;
    for (std::size_t face = 0; face < faces.materialOf.size(); ++face) {
        const std::uint32_t first = faces.firstCorner[face];
        polygon.clear();
        for (std::uint32_t i = first; i < faces.firstCorner[face + 1]; ++i)
            polygon.push_back(scan.positions[faces.corners[i].position]);
        triangulate(polygon, triangles);
        for (auto corners : triangles) {
            for (std::uint32_t& corner : corners)
                corner += first;
            const auto at = [&](int i) { return rounded[faces.corners[corners[i]].position]; };
            if (areaVectorOf(at(0), at(1), at(2)) == dvec3(0.0))
                ++dropped;
            else
                result.push_back(
                    {corners, faces.materialOf[face], groupOf(scan, face), std::ranges::all_of(corners, [&](std::uint32_t corner) {
                         return hasTexcoord(scan, faces.corners[corner]);
                     }),
                     static_cast<std::uint32_t>(result.size())});
        }
    }
    return result;
}

/// Triangles of one material together, materials in the order in which they first have a triangle. Those without texture
/// coordinates are a part of their own: no image can be laid on them.
std::vector<MeshPart> groupByMaterial(std::vector<CornerTriangle>& triangles, const ObjFaces& faces) {
    constexpr std::uint32_t kUnseen = 0xffffffffu;
    std::vector<std::uint32_t> rank(2 * faces.materialNames.size(), kUnseen);
    const auto kindOf = [](const CornerTriangle& t) { return 2 * t.material + (t.hasTexcoords ? 1 : 0); };
    std::vector<MeshPart> parts;
    for (const CornerTriangle& triangle : triangles) {
        std::uint32_t& part = rank[kindOf(triangle)];
        if (part == kUnseen) {
            part = static_cast<std::uint32_t>(parts.size());
            parts.push_back({faces.materialNames[triangle.material], 0, 0, triangle.hasTexcoords});
        }
        ++parts[part].triangleCount;
    }
    for (std::size_t i = 1; i < parts.size(); ++i)
        parts[i].firstTriangle = parts[i - 1].firstTriangle + parts[i - 1].triangleCount;
    if (parts.size() > 1)
        std::ranges::stable_sort(triangles, {}, [&](const CornerTriangle& t) { return rank[kindOf(t)]; });
    return parts;
}

} // namespace

dvec3 chooseOrigin(const dvec3& lower, const dvec3& upper) {
    const dvec3 extent = upper - lower;
    const double size = glm::max(extent.x, glm::max(extent.y, extent.z));
    const dvec3 farthest = glm::max(glm::abs(lower), glm::abs(upper));
    // Up to eight sizes away, rounding to float moves a vertex by at most 2^-22 of the mesh's size (24 bits, 3 of them
    // spent on the distance, half a unit of error): far below a pixel.
    constexpr double kFarInSizes = 8.0;
    if (!(size > 0.0) || glm::max(farthest.x, glm::max(farthest.y, farthest.z)) <= kFarInSizes * size)
        return dvec3(0.0);
    const double grid = std::exp2(std::ceil(std::log2(size)));
    return glm::round((lower + 0.5 * extent) / grid) * grid;
}

Mesh buildMesh(const ObjScan& scan, const ObjFaces& faces) {
    Mesh mesh;
    mesh.originObject = originOf(scan, faces);
    const std::vector<vec3> rounded = roundedPositions(scan.positions, mesh.originObject);
    std::vector<CornerTriangle> triangles = split(scan, faces, rounded, mesh.droppedTriangles);
    mesh.parts = groupByMaterial(triangles, faces);

    const auto areaVector = [&](const CornerTriangle& t) {
        const auto at = [&](int i) { return rounded[faces.corners[t.corners[i]].position]; };
        return areaVectorOf(at(0), at(1), at(2));
    };
    GroupNormals smooth(scan.smoothingGroups.empty() ? std::span<const vec3>() : std::span<const vec3>(rounded));
    std::vector<std::uint32_t> positions; // of a face
    for (std::size_t face = 0; face < scan.smoothingGroups.size(); ++face) {
        positions.clear();
        for (std::uint32_t i = faces.firstCorner[face]; i < faces.firstCorner[face + 1]; ++i)
            positions.push_back(faces.corners[i].position);
        smooth.add(scan.smoothingGroups[face], positions);
    }

    // Corners become vertices; equal corners share one.
    VertexWelder welder(3 * triangles.size());
    mesh.triangles.reserve(triangles.size());
    for (const CornerTriangle& triangle : triangles) {
        const vec3 flat = vec3(glm::normalize(areaVector(triangle))) + vec3(0.0f);
        uvec3 vertices;
        for (int i = 0; i < 3; ++i) {
            const ObjCorner& corner = faces.corners[triangle.corners[i]];
            const vec3 given = corner.normal < 0 ? vec3(0.0f) : scan.normals[corner.normal] + vec3(0.0f);
            vertices[i] = welder.index(
                {.position = rounded[corner.position],
                 .normal = given != vec3(0.0f) ? given : smooth.at(triangle.group, corner.position, flat),
                 .texcoord = triangle.hasTexcoords ? scan.texcoords[corner.texcoord] + vec2(0.0f) : vec2(0.0f),
                 .color = scan.colors.empty() ? vec3(0.0f) : scan.colors[corner.position]});
        }
        mesh.triangles.push_back(vertices);
    }
    if (!std::ranges::is_sorted(triangles, {}, &CornerTriangle::place))
        for (const CornerTriangle& triangle : triangles)
            mesh.fileOrder.push_back(triangle.place);
    mesh.positionsMesh = welder.of(&Vertex::position);
    mesh.normalsMesh = welder.of(&Vertex::normal);
    if (std::ranges::any_of(mesh.parts, &MeshPart::hasTexcoords)) mesh.texcoords = welder.of(&Vertex::texcoord);
    if (!scan.colors.empty()) mesh.colors = welder.of(&Vertex::color);
    return mesh;
}

} // namespace shadowlab::scene
