// The steps from polygons to meshes, in the order of buildMeshes at the end.
// SPDX-License-Identifier: MIT
#include "techniques/foundation/scene/obj/obj_mesh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>

#include "techniques/foundation/scene/obj/mesh_pieces.h"
#include "techniques/foundation/scene/obj/outliers.h"
#include "techniques/foundation/scene/obj/polygon_triangulation.h"
#include "techniques/foundation/scene/obj/smoothing_groups.h"
#include "techniques/foundation/scene/obj/vertex_welder.h"
#include "techniques/foundation/scene/query/topology/triangle_order.h"

namespace shadowlab::scene {

namespace {

struct CornerTriangle {
    std::array<std::uint32_t, 3> corners; ///< indices into ObjFaces::corners
    std::uint32_t face, material;
    bool hasTexcoords;       ///< at all three corners
    std::uint32_t place = 0; ///< in the order of the file, among those of its piece
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

/// Rounds each position once, about an origin; adding zero turns -0 into +0, so that equal positions have equal bits.
class Rounded {
public:
    Rounded(const std::vector<dvec3>& positions, const dvec3& origin) : positions_(positions), origin_(origin) {}
    vec3 operator[](std::uint32_t position) const { return vec3(positions_[position] - origin_) + vec3(0.0f); }

private:
    const std::vector<dvec3>& positions_;
    dvec3 origin_;
};

bool hasTexcoord(const ObjScan& scan, const ObjCorner& corner) {
    return corner.texcoord >= 0 && std::isfinite(scan.texcoords[corner.texcoord].x + scan.texcoords[corner.texcoord].y);
}

/// Perpendicular to the triangle, with twice its area as length; the difference of floats and its products are exact
/// in double for all but absurd ratios of size, so a straight triangle gives exactly zero.
dvec3 areaVectorOf(const vec3& a, const vec3& b, const vec3& c) {
    return glm::cross(dvec3(b) - dvec3(a), dvec3(c) - dvec3(a));
}

/// All polygons split, in double.
std::vector<CornerTriangle> split(const ObjScan& scan, const ObjFaces& faces) {
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
            const bool hasTexcoords =
                std::ranges::all_of(corners, [&](std::uint32_t corner) { return hasTexcoord(scan, faces.corners[corner]); });
            result.push_back({corners, static_cast<std::uint32_t>(face), faces.materialOf[face], hasTexcoords});
        }
    }
    return result;
}

/// Origins of the mesh, and which triangle counts from which. A look at the shortest edge of all shows that most meshes need one.
MeshPieces piecesFor(const ObjScan& scan, const ObjFaces& faces, std::span<const CornerTriangle> triangles) {
    const auto positionOf = [&](std::size_t corner) -> const dvec3& { return scan.positions[faces.corners[corner].position]; };
    const dvec3 usual = originOf(scan, faces);
    const CommonPlace place(faces.corners.size(), positionOf);
    double shortestSquared = std::numeric_limits<double>::infinity(), farthest = 0;
    std::vector<std::uint32_t> reaching; // triangles with a corner that lies far from most
    for (std::uint32_t t = 0; t < triangles.size(); ++t) {
        bool reachesOut = false;
        for (std::size_t i = 0; i < 3; ++i) {
            const dvec3& a = positionOf(triangles[t].corners[i]);
            const dvec3 edge = positionOf(triangles[t].corners[(i + 1) % 3]) - a;
            if (const double squared = glm::dot(edge, edge); squared > 0) shortestSquared = std::min(shortestSquared, squared);
            const dvec3 out = glm::abs(a - usual);
            farthest = std::max({farthest, out.x, out.y, out.z});
            reachesOut = reachesOut || place.isFar(a);
        }
        if (reachesOut) reaching.push_back(t);
    }
    MeshPieces pieces;
    if (farthest > kReachInEdges * std::sqrt(shortestSquared)) {
        std::vector<uvec3> corners;
        corners.reserve(triangles.size());
        for (const CornerTriangle& t : triangles)
            corners.emplace_back(faces.corners[t.corners[0]].position, faces.corners[t.corners[1]].position,
                                 faces.corners[t.corners[2]].position);
        pieces = meshPieces(scan.positions, corners, usual);
    }
    if (!pieces.origins.empty()) return pieces;
    pieces.origins.push_back(usual);
    if (reaching.empty()) return pieces;
    // One origin holds all, but the box around the rest stays small without them.
    pieces.origins.push_back(usual);
    pieces.pieceOf.assign(triangles.size(), 0);
    for (const std::uint32_t triangle : reaching)
        pieces.pieceOf[triangle] = 1;
    return pieces;
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

namespace {

/// Where the normals come from.
struct NormalSource {
    bool ofFile = true;                ///< a corner's own, where it has one
    bool ofTriangles = false;          ///< those of groups are means of triangles, not of faces, as withNormals() takes them
    std::vector<std::uint32_t> groups; ///< of each face; empty: none has one
    std::vector<dvec3> positions;      ///< from which those of groups are computed

    [[nodiscard]] std::uint32_t groupOf(std::uint32_t face) const { return groups.empty() ? 0 : groups[face]; }
};

Mesh buildPiece(const ObjScan& scan, const ObjFaces& faces, std::vector<CornerTriangle> triangles, const dvec3& origin,
                const NormalSource& normals, const GroupNormals& smooth) {
    Mesh mesh;
    mesh.originObject = origin;
    const Rounded rounded(scan.positions, origin);
    const auto areaVector = [&](const CornerTriangle& t) {
        const auto at = [&](std::size_t i) { return rounded[faces.corners[t.corners[i]].position]; };
        return areaVectorOf(at(0), at(1), at(2));
    };
    // Triangles that have no area once rounded are counted, not kept.
    mesh.droppedTriangles = static_cast<std::uint32_t>(
        std::erase_if(triangles, [&](const CornerTriangle& triangle) { return areaVector(triangle) == dvec3(0.0); }));
    for (std::uint32_t i = 0; i < triangles.size(); ++i)
        triangles[i].place = i;
    mesh.parts = groupByMaterial(triangles, faces);

    // Corners become vertices; equal corners share one.
    VertexWelder welder(3 * triangles.size());
    mesh.triangles.reserve(triangles.size());
    for (const CornerTriangle& triangle : triangles) {
        const vec3 flat = vec3(glm::normalize(areaVector(triangle))) + vec3(0.0f);
        uvec3 vertices;
        for (int i = 0; i < 3; ++i) {
            const ObjCorner& corner = faces.corners[triangle.corners[i]];
            const bool hasOwn = normals.ofFile && corner.normal >= 0;
            const vec3 given = hasOwn ? scan.normals[corner.normal] + vec3(0.0f) : vec3(0.0f);
            vertices[i] = welder.index(
                {.position = rounded[corner.position],
                 .normal = given != vec3(0.0f) ? given : smooth.at(normals.groupOf(triangle.face), corner.position, flat),
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

/// Of a mesh in one piece, the normals of groups are those of its rounded triangles. Pieces share the normals where they meet: these
/// are of the file's numbers, and other normals than the file's cannot be left to each piece (withNormals).
NormalSource normalSource(const ObjScan& scan, const MeshPieces& pieces, NormalMode mode, std::size_t faceCount) {
    NormalSource source;
    source.groups = scan.smoothingGroups;
    const bool inPieces = pieces.origins.size() > 1;
    if (inPieces && mode != NormalMode::file) {
        source.ofFile = false;
        source.ofTriangles = true;
        source.groups.assign(mode == NormalMode::smooth ? faceCount : 0, 1);
    }
    if (source.groups.empty()) return source;
    source.positions = scan.positions;
    const Rounded rounded(scan.positions, pieces.origins.front());
    for (std::uint32_t i = 0; !inPieces && i < source.positions.size(); ++i)
        source.positions[i] = dvec3(rounded[i]);
    return source;
}

GroupNormals groupNormals(const NormalSource& source, const ObjFaces& faces, std::span<const CornerTriangle> triangles) {
    GroupNormals smooth(source.positions);
    std::vector<std::uint32_t> positions; // of a face
    if (source.ofTriangles && !source.groups.empty()) {
        for (const CornerTriangle& triangle : triangles) {
            positions.clear();
            for (const std::uint32_t corner : triangle.corners)
                positions.push_back(faces.corners[corner].position);
            smooth.add(source.groupOf(triangle.face), positions);
        }
        return smooth;
    }
    for (std::size_t face = 0; face < source.groups.size(); ++face) {
        positions.clear();
        for (std::uint32_t i = faces.firstCorner[face]; i < faces.firstCorner[face + 1]; ++i)
            positions.push_back(faces.corners[i].position);
        smooth.add(source.groups[face], positions);
    }
    return smooth;
}

/// Triangles stand as in the file, but for the parts.
std::vector<Mesh> inFileOrder(const ObjScan& scan, const ObjFaces& faces, NormalMode mode) {
    std::vector<CornerTriangle> triangles = split(scan, faces);
    const MeshPieces pieces = piecesFor(scan, faces, triangles);
    const NormalSource normals = normalSource(scan, pieces, mode, faces.materialOf.size());
    const GroupNormals smooth = groupNormals(normals, faces, triangles);
    std::vector<Mesh> meshes;
    if (pieces.origins.size() == 1) {
        meshes.push_back(buildPiece(scan, faces, std::move(triangles), pieces.origins.front(), normals, smooth));
        if (mode != NormalMode::file) meshes.front() = withNormals(meshes.front(), mode);
        return meshes;
    }
    std::vector<std::vector<CornerTriangle>> trianglesOf(pieces.origins.size());
    for (std::size_t i = 0; i < triangles.size(); ++i)
        trianglesOf[pieces.pieceOf[i]].push_back(triangles[i]);
    for (std::size_t i = 0; i < trianglesOf.size(); ++i)
        meshes.push_back(buildPiece(scan, faces, std::move(trianglesOf[i]), pieces.origins[i], normals, smooth));
    return meshes;
}

} // namespace

std::vector<Mesh> buildMeshes(const ObjScan& scan, const ObjFaces& faces, NormalMode mode) {
    std::vector<Mesh> meshes = inFileOrder(scan, faces, mode);
    for (Mesh& mesh : meshes)
        keepNeighboursTogether(mesh);
    return meshes;
}

} // namespace shadowlab::scene
