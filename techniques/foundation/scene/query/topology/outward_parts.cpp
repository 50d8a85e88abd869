// SPDX-License-Identifier: MIT
#include "techniques/foundation/scene/query/topology/outward_parts.h"

#include <algorithm>

#include "techniques/foundation/base/disjoint_sets.h"
#include "techniques/foundation/scene/query/topology/simple_surface.h"

namespace shadowlab::scene {

namespace {

/// The connected component of each triangle, named by one of its triangles.
std::vector<std::uint32_t> pieces(std::size_t triangles, const MeshTopology& topology) {
    DisjointSets joined(triangles);
    for (const Edge& edge : topology.edges)
        for (std::uint32_t u = 1; u < edge.useCount; ++u)
            joined.join(topology.uses[edge.firstUse].triangle, topology.uses[edge.firstUse + u].triangle);
    return joined.names();
}

/// The contractions that are tried, each as the set of axes along which the piece shrinks: three, toward a point; two,
/// toward a line; one, toward a plane.
constexpr unsigned kAxisSets[] = {7, 3, 5, 6, 1, 2, 4};

/// True if the triangle moves with its inside ahead. In the contraction along `axes` a point q moves by -(q - middle) in
/// those axes. The product with the normal is linear in q, so its sign at the corners decides.
bool sweepsInward(const dvec3 (&corner)[3], const dvec3& middle, unsigned axes) {
    const dvec3 normal = glm::cross(corner[1] - corner[0], corner[2] - corner[0]);
    for (const dvec3& q : corner) {
        double outward = 0;
        for (int axis = 0; axis < 3; ++axis)
            if (axes & (1u << axis)) outward += normal[axis] * (q[axis] - middle[axis]);
        if (outward < 0) return false;
    }
    return true;
}

/// The triangles of each closed piece for which no contraction works.
std::vector<std::vector<std::uint32_t>> undecided(std::span<const std::uint32_t> pieceOf,
                                                  std::span<const std::uint8_t> open, const std::vector<bool>& closed) {
    std::vector<std::vector<std::uint32_t>> pieces;
    std::vector<std::int32_t> number(pieceOf.size(), -1);
    for (std::uint32_t t = 0; t < pieceOf.size(); ++t) {
        const std::uint32_t piece = pieceOf[t];
        if (open[piece] || !closed[piece]) continue;
        if (number[piece] < 0) {
            number[piece] = static_cast<std::int32_t>(pieces.size());
            pieces.emplace_back();
        }
        pieces[static_cast<std::size_t>(number[piece])].push_back(t);
    }
    return pieces;
}

/// Six times the signed volume: positive if the front faces look outward.
double volume(const Mesh& mesh, std::span<const std::uint32_t> triangles) {
    const dvec3 from(mesh.positionsMesh[mesh.triangles[triangles.front()].x]);
    double sum = 0;
    for (const std::uint32_t t : triangles) {
        const uvec3& v = mesh.triangles[t];
        sum += glm::dot(dvec3(mesh.positionsMesh[v.x]) - from,
                        glm::cross(dvec3(mesh.positionsMesh[v.y]) - from, dvec3(mesh.positionsMesh[v.z]) - from));
    }
    return sum;
}

/// A file may wind some of its triangles the other way than their normals say; those have all three behind them. A single one may be behind a sliver.
bool haveNormalsOnFront(const Mesh& mesh) {
    return !mesh.normalsMesh.empty() && std::ranges::all_of(mesh.triangles, [&](const uvec3& t) {
        const dvec3 a(mesh.positionsMesh[t.x]), b(mesh.positionsMesh[t.y]), c(mesh.positionsMesh[t.z]);
        const dvec3 front = glm::cross(b - a, c - a);
        const auto isOnFront = [&](std::uint32_t vertex) { return glm::dot(front, dvec3(mesh.normalsMesh[vertex])) > 0; };
        return isOnFront(t.x) || isOnFront(t.y) || isOnFront(t.z);
    });
}

} // namespace

OutwardParts outwardParts(const Mesh& mesh, const MeshTopology& topology) {
    const std::size_t triangles = mesh.triangles.size();
    const std::vector<std::uint32_t> pieceOf = pieces(triangles, topology);
    std::vector<OutwardParts::Box> boxOf(triangles);
    const auto corner = [&](std::uint32_t v) { return dvec3(mesh.positionsMesh[v]); };
    for (std::size_t t = 0; t < triangles; ++t) {
        OutwardParts::Box& box = boxOf[pieceOf[t]];
        for (const std::uint32_t v : {mesh.triangles[t].x, mesh.triangles[t].y, mesh.triangles[t].z}) {
            box.lowerMesh = glm::min(box.lowerMesh, corner(v));
            box.upperMesh = glm::max(box.upperMesh, corner(v));
        }
    }
    // Per piece, the contractions that are still possible: one bit for each of kAxisSets.
    std::vector<std::uint8_t> open(triangles, 0x7f);
    std::vector<bool> closed(triangles, true);
    for (const Edge& edge : topology.edges)
        if (kindOf(topology, edge) != EdgeKind::closed) {
            const std::uint32_t piece = pieceOf[topology.uses[edge.firstUse].triangle];
            closed[piece] = false;
            open[piece] = 0;
        }
    for (std::size_t t = 0; t < triangles; ++t) {
        const OutwardParts::Box& box = boxOf[pieceOf[t]];
        const dvec3 middle = 0.5 * (box.lowerMesh + box.upperMesh);
        const uvec3& v = mesh.triangles[t];
        const dvec3 corners[3] = {corner(v.x), corner(v.y), corner(v.z)};
        for (unsigned way = 0; way < 7; ++way)
            if ((open[pieceOf[t]] >> way & 1u) && !sweepsInward(corners, middle, kAxisSets[way]))
                open[pieceOf[t]] &= static_cast<std::uint8_t>(~(1u << way));
    }
    for (const std::vector<std::uint32_t>& piece : undecided(pieceOf, open, closed))
        // For a shared mesh this may be known already.
        if (mesh.outward || (volume(mesh, piece) > 0 && isCertainlySimple(mesh, topology, piece)))
            open[pieceOf[piece.front()]] = 1;

    OutwardParts parts;
    std::vector<std::int32_t> number(triangles, OutwardParts::kNone);
    for (std::size_t piece = 0; piece < triangles; ++piece)
        if (pieceOf[piece] == piece && open[piece]) {
            number[piece] = static_cast<std::int32_t>(parts.boxes.size());
            parts.boxes.push_back(boxOf[piece]);
        }
    for (const std::uint32_t piece : pieceOf)
        parts.partOfTriangle.push_back(number[piece]);
    return parts;
}

bool isOutward(const Mesh& mesh) {
    const OutwardParts parts = outwardParts(mesh, buildTopology(mesh));
    return !parts.boxes.empty() &&
           std::ranges::find(parts.partOfTriangle, OutwardParts::kNone) == parts.partOfTriangle.end();
}

std::shared_ptr<const Mesh> sharedMesh(Mesh mesh) {
    mesh.outward = false; // the mesh may be a changed copy of another one
    mesh.outward = isOutward(mesh);
    mesh.normalsOnFront = haveNormalsOnFront(mesh);
    return std::make_shared<const Mesh>(std::move(mesh));
}

void keepFrontFacesAlone(std::span<std::int8_t> facing, const OutwardParts& parts, const dvec4& lightMesh) {
    std::vector<bool> outside;
    for (const OutwardParts::Box& box : parts.boxes)
        outside.push_back(lightMesh.w == 0 || glm::any(glm::lessThan(dvec3(lightMesh), box.lowerMesh)) ||
                          glm::any(glm::greaterThan(dvec3(lightMesh), box.upperMesh)));
    if (std::ranges::find(outside, true) == outside.end()) return;
    for (std::size_t t = 0; t < facing.size(); ++t)
        if (const std::int32_t part = parts.partOfTriangle[t];
            facing[t] < 0 && part != OutwardParts::kNone && outside[static_cast<std::size_t>(part)])
            facing[t] = 0;
}

} // namespace shadowlab::scene
