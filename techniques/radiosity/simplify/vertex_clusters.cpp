// SPDX-License-Identifier: MIT
#include "techniques/radiosity/simplify/vertex_clusters.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include <Eigen/Eigenvalues>

#include "techniques/foundation/scene/query/topology/mesh_topology.h"

namespace shadowlab::radiosity {

namespace {

// The three coordinates of a cell in one number: 21 bits each.
constexpr int kBits = 21;

// Marks a vertex that is not clustered: this bit, and the vertex's own number.
constexpr std::uint64_t kOwn = std::uint64_t{1} << 63;

// The surface within a cell leaves about two triangles.
constexpr double kTrianglesOfCell = 2;

// Eigenvalues below this share of the largest are noise (Lindstrom's value).
constexpr double kSingular = 1e-3;

// The normal of a triangle of float vertices that is narrower than this share of its length may be wrong by a hundredth and more.
constexpr double kNarrow = 1e-3;

/// The quadric error: sums over planes with the normal n, not unit, through points p: n n^T and n (n . p).
struct Quadric {
    Eigen::Matrix3d squares = Eigen::Matrix3d::Zero();
    Eigen::Vector3d product = Eigen::Vector3d::Zero();
    dvec3 places{0.0}; ///< sum over the vertices
    double vertices = 0;
    void add(const dvec3& normal, const dvec3& point) {
        const Eigen::Vector3d n(normal.x, normal.y, normal.z);
        squares += n * n.transpose();
        product += glm::dot(normal, point) * n;
    }
    /// The point with the least sum of squared distances; in directions in which that is not determined, as near to the mean of
    /// the vertices as possible. Directions are dropped, the least certain first, until the point lies in the cell.
    [[nodiscard]] dvec3 best(const dvec3& lower, const dvec3& upper) const {
        const dvec3 mean = places / vertices;
        const Eigen::Vector3d from(mean.x, mean.y, mean.z);
        const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(squares);
        const Eigen::Vector3d values = solver.eigenvalues(); // in rising order
        const Eigen::Vector3d pull = solver.eigenvectors().transpose() * (product - squares * from);
        for (int first = 0; first < 3; ++first) {
            if (!(values[first] > kSingular * values[2])) continue;
            Eigen::Vector3d move = Eigen::Vector3d::Zero();
            for (int i = first; i < 3; ++i)
                move += pull[i] / values[i] * solver.eigenvectors().col(i);
            const dvec3 place = mean + dvec3(move[0], move[1], move[2]);
            if (glm::all(glm::lessThanEqual(lower, place)) && glm::all(glm::lessThanEqual(place, upper))) return place;
        }
        return mean;
    }
};

bool hasThree(const std::array<std::uint64_t, 3>& cells) {
    return cells[0] != cells[1] && cells[1] != cells[2] && cells[2] != cells[0];
}

/// The normal of the triangle; its length is twice the area.
dvec3 areaVector(std::span<const dvec3> positions, const uvec3& t) {
    return glm::cross(positions[t.y] - positions[t.x], positions[t.z] - positions[t.x]);
}

bool isNarrow(const ClusteredMesh& mesh, const uvec3& t) {
    const dvec3 &a = mesh.positions[t.x], &b = mesh.positions[t.y], &c = mesh.positions[t.z];
    const double longest = std::max({glm::length(b - a), glm::length(c - b), glm::length(a - c)});
    return !(glm::length(areaVector(mesh.positions, t)) > kNarrow * longest * longest);
}

/// A triangle whose corners lie in three cells.
struct Spanned {
    std::array<std::uint32_t, 3> corners; ///< rising
    std::uint32_t original;
    bool isTurned;     ///< its winding is reversed
    bool facesTheSame; ///< its normal still points the same way
};

/// Of triangles with the same corners, one is kept if more face one way than the other: where a surface folds, opposite triangles
/// cancel, and what is closed stays closed. If both are equally many and none has flipped, they are the two sides of a thin
/// sheet, and both are kept.
void keep(std::span<const Spanned> same, std::vector<Spanned>& kept) {
    const auto turned = std::ranges::count(same, true, &Spanned::isTurned);
    const auto others = static_cast<std::ptrdiff_t>(same.size()) - turned;
    for (const bool isTurned : {false, true}) {
        const auto one = std::ranges::find(same, isTurned, &Spanned::isTurned);
        const bool isMore = isTurned ? turned > others : others > turned;
        if (isMore) kept.push_back(*one);
    }
    if (turned != others) return;
    std::vector<Spanned> sides;
    for (const bool isTurned : {false, true})
        for (const Spanned& one : same)
            if (one.isTurned == isTurned && one.facesTheSame) {
                sides.push_back(one);
                break;
            }
    if (sides.size() == 2) kept.insert(kept.end(), sides.begin(), sides.end());
}

} // namespace

VertexClusters::VertexClusters(const scene::Object& object) : mesh_(*object.mesh) {
    const dmat3 worldFromObject(object.worldFromObject);
    positions_.reserve(mesh_.positionsMesh.size());
    for (const vec3& positionMesh : mesh_.positionsMesh)
        positions_.push_back(worldFromObject * dvec3(positionMesh));
    lower_ = upper_ = positions_.empty() ? dvec3(0.0) : positions_.front();
    for (const dvec3& position : positions_) {
        lower_ = glm::min(lower_, position);
        upper_ = glm::max(upper_, position);
    }
    for (std::uint32_t part = 0; part < mesh_.parts.size(); ++part)
        parts_.resize(parts_.size() + mesh_.parts[part].triangleCount, part);
    findPieces();
    const scene::MeshTopology topology = scene::buildTopology(mesh_);
    for (const scene::Edge& edge : topology.edges) {
        const std::span uses(topology.uses.data() + edge.firstUse, edge.useCount);
        const bool isOnePart = std::ranges::all_of(
            uses, [&](const scene::EdgeUse& use) { return parts_[use.triangle] == parts_[uses[0].triangle]; });
        if (isOnePart && uses.size() > 1) continue;
        for (const scene::EdgeUse& use : uses)
            borders_.push_back({edge.a, edge.b, use.triangle});
    }
}

void VertexClusters::findPieces() {
    std::vector<std::uint32_t> byPlace(positions_.size());
    std::iota(byPlace.begin(), byPlace.end(), 0u);
    const auto place = [&](std::uint32_t v) {
        const vec3& p = mesh_.positionsMesh[v];
        return std::array{p.x, p.y, p.z};
    };
    std::ranges::stable_sort(byPlace, {}, place);
    placeOfVertex_.resize(byPlace.size());
    for (std::size_t i = 0; i < byPlace.size(); ++i)
        placeOfVertex_[byPlace[i]] =
            i > 0 && place(byPlace[i]) == place(byPlace[i - 1]) ? placeOfVertex_[byPlace[i - 1]] : byPlace[i];
    // Connected pieces by union-find; the root is always the smallest number.
    pieceOfVertex_ = placeOfVertex_;
    const auto rootOf = [&](std::uint32_t v) {
        while (pieceOfVertex_[v] != v)
            v = pieceOfVertex_[v] = pieceOfVertex_[pieceOfVertex_[v]];
        return v;
    };
    for (const uvec3& t : mesh_.triangles)
        for (const std::uint32_t other : {t.y, t.z}) {
            const auto [least, most] = std::minmax({rootOf(t.x), rootOf(other)});
            pieceOfVertex_[most] = least;
        }
    for (std::uint32_t v = 0; v < pieceOfVertex_.size(); ++v)
        pieceOfVertex_[v] = rootOf(v);
    pieces_.resize(positions_.size());
    for (const uvec3& t : mesh_.triangles) {
        Piece& piece = pieces_[pieceOfVertex_[t.x]];
        piece.area += 0.5 * glm::length(areaVector(positions_, t));
        ++piece.triangles;
    }
}

/// The lattice is centred on the object, so that a symmetric object stays symmetric.
dvec3 VertexClusters::latticeOrigin(const dvec3& cell) const {
    const dvec3 cells = glm::max(glm::ceil((upper_ - lower_) / cell), 1.0);
    return 0.5 * (lower_ + upper_) - 0.5 * cell * cells;
}

std::vector<std::uint64_t> VertexClusters::cellsOf(const dvec3& cell) const {
    const dvec3 origin = latticeOrigin(cell), last = glm::max(glm::ceil((upper_ - lower_) / cell), 1.0) - 1.0;
    const double side = std::max({cell.x, cell.y, cell.z});
    std::vector<std::uint64_t> cells;
    cells.reserve(positions_.size());
    for (std::size_t v = 0; v < positions_.size(); ++v) {
        const Piece& piece = pieces_[pieceOfVertex_[v]];
        if (static_cast<double>(piece.triangles) <= kTrianglesOfCell * piece.area / (side * side)) {
            cells.push_back(kOwn | placeOfVertex_[v]);
            continue;
        }
        const dvec3& position = positions_[v];
        const dvec3 place = glm::clamp(glm::floor((position - origin) / cell), dvec3(0.0), last);
        cells.push_back((static_cast<std::uint64_t>(place.x) << 2 * kBits) |
                        (static_cast<std::uint64_t>(place.y) << kBits) | static_cast<std::uint64_t>(place.z));
    }
    return cells;
}

std::size_t VertexClusters::roughCount(const dvec3& cell) const {
    const std::vector<std::uint64_t> cells = cellsOf(cell);
    return static_cast<std::size_t>(std::ranges::count_if(mesh_.triangles, [&](const uvec3& t) {
        return hasThree({cells[t.x], cells[t.y], cells[t.z]});
    }));
}

void VertexClusters::placeVertices(ClusteredMesh& mesh, std::span<const std::uint64_t> cells, const dvec3& cell) const {
    std::vector<Quadric> quadrics(cells.size());
    for (std::size_t v = 0; v < positions_.size(); ++v) {
        Quadric& quadric = quadrics[mesh.clusterOfVertex[v]];
        quadric.places += positions_[v];
        quadric.vertices += 1;
    }
    for (const uvec3& t : mesh_.triangles) {
        std::array<std::uint32_t, 3> clusters{};
        for (int corner = 0; corner < 3; ++corner)
            clusters[corner] = mesh.clusterOfVertex[t[corner]];
        std::ranges::sort(clusters);
        const auto repeated = std::ranges::unique(clusters);
        for (auto cluster = clusters.begin(); cluster != repeated.begin(); ++cluster)
            quadrics[*cluster].add(areaVector(positions_, t), positions_[t.x]);
    }
    for (const Border& border : borders_) {
        const dvec3 side = positions_[border.to] - positions_[border.from];
        const dvec3 across = glm::cross(side, areaVector(positions_, mesh_.triangles[border.triangle]));
        const double length = glm::length(across);
        if (!(length > 0)) continue;
        const dvec3 normal = glm::dot(side, side) / length * across; // weighted as a square of that side
        const std::uint32_t first = mesh.clusterOfVertex[border.from], second = mesh.clusterOfVertex[border.to];
        quadrics[first].add(normal, positions_[border.from]);
        if (second != first) quadrics[second].add(normal, positions_[border.from]);
    }
    const dvec3 origin = latticeOrigin(cell);
    constexpr std::uint64_t kMask = (std::uint64_t{1} << kBits) - 1;
    constexpr double kRounded = 1e-6; // vertices of the surface may lie on the lattice planes
    for (std::size_t i = 0; i < cells.size(); ++i) {
        if (cells[i] & kOwn) {
            mesh.positions.push_back(positions_[cells[i] & ~kOwn]);
            continue;
        }
        const dvec3 place(static_cast<double>(cells[i] >> 2 * kBits), static_cast<double>(cells[i] >> kBits & kMask),
                          static_cast<double>(cells[i] & kMask));
        mesh.positions.push_back(
            quadrics[i].best(origin + cell * (place - kRounded), origin + cell * (place + 1.0 + kRounded)));
    }
}

ClusteredMesh VertexClusters::clustered(const dvec3& cell) const {
    ClusteredMesh mesh;
    const std::vector<std::uint64_t> cellOfVertex = cellsOf(cell);
    std::vector<std::uint64_t> cells = cellOfVertex;
    std::ranges::sort(cells);
    const auto repeated = std::ranges::unique(cells);
    cells.erase(repeated.begin(), repeated.end());
    for (const std::uint64_t one : cellOfVertex)
        mesh.clusterOfVertex.push_back(
            static_cast<std::uint32_t>(std::ranges::lower_bound(cells, one) - cells.begin()));
    placeVertices(mesh, cells, cell);

    std::vector<Spanned> spanned;
    for (std::uint32_t t = 0; t < mesh_.triangles.size(); ++t) {
        std::array<std::uint32_t, 3> corners{};
        for (int corner = 0; corner < 3; ++corner)
            corners[corner] = mesh.clusterOfVertex[mesh_.triangles[t][corner]];
        if (!hasThree({corners[0], corners[1], corners[2]})) continue;
        std::ranges::rotate(corners, std::ranges::min_element(corners));
        const dvec3 was = areaVector(positions_, mesh_.triangles[t]);
        const dvec3 is = areaVector(mesh.positions, {corners[0], corners[1], corners[2]});
        const bool isTurned = corners[1] > corners[2];
        if (isTurned) std::swap(corners[1], corners[2]);
        spanned.push_back({corners, t, isTurned, glm::dot(was, is) > 0});
    }
    // Triangles with the same corners are adjacent now, in the order of the mesh.
    std::ranges::stable_sort(spanned, {}, &Spanned::corners);
    std::vector<Spanned> kept;
    for (auto first = spanned.begin(), end = first; first != spanned.end(); first = end) {
        while (end != spanned.end() && end->corners == first->corners)
            ++end;
        if (!isNarrow(mesh, {first->corners[0], first->corners[1], first->corners[2]})) keep({first, end}, kept);
    }
    std::ranges::sort(kept, {}, &Spanned::original);
    for (const Spanned& one : kept) {
        const auto [a, b, c] = one.corners;
        mesh.triangles.push_back(one.isTurned ? uvec3(a, c, b) : uvec3(a, b, c));
        mesh.parts.push_back(parts_[one.original]);
    }
    return mesh;
}

} // namespace shadowlab::radiosity
