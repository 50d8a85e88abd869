// Simplifies a mesh by vertex clustering: all vertices in one cell of a lattice become one.
//
// Triangles with two corners in one cell vanish; the others span from cell to cell. The vertex of a cell lies where the sum of
// squared distances to the planes of its triangles is least, each weighted by the square of its area: on edges and corners of the
// surface, if it has any, and otherwise such that the surface keeps its mean position. P. Lindstrom, "Out-of-Core Simplification
// of Large Polygonal Models", SIGGRAPH 2000; vertex clustering goes back to J. Rossignac and P. Borrel, 1993. Where the mesh or
// one of its parts ends, a further plane through the edge, perpendicular to the triangle, preserves the outline. Connected pieces
// with no more triangles than the cells would leave for their area are not changed: a table top, thinner than a cell, would
// vanish.
// SPDX-License-Identifier: MIT
#pragma once
#include <span>
#include <vector>

#include "techniques/foundation/scene/model/scene.h"

namespace shadowlab::radiosity {

/// Positions are in metres, along the world's axes, relative to the object's origin.
struct ClusteredMesh {
    std::vector<dvec3> positions;
    std::vector<uvec3> triangles;
    std::vector<std::uint32_t> parts;           ///< the mesh part of each triangle
    std::vector<std::uint32_t> clusterOfVertex; ///< for each vertex of the original its vertex in `positions`
};

class VertexClusters {
public:
    /// The object's mesh must outlive this object.
    explicit VertexClusters(const scene::Object& object);

    /// How many triangles remain with cells of that size along each axis, metres; coinciding ones are counted more than once.
    [[nodiscard]] std::size_t roughCount(const dvec3& cell) const;
    /// The mesh with cells of that size. Of coinciding triangles one is kept for all that face one way, less those that face the
    /// other; both where the two sides of a thin sheet coincide. Triangles no wider than a thousandth of their length are left
    /// out: their third corner lies on a side, so no gap opens, but their normal would be arbitrary.
    [[nodiscard]] ClusteredMesh clustered(const dvec3& cell) const;

    /// The diagonal of the mesh's bounding box, metres. Cells of that size leave nothing.
    [[nodiscard]] double size() const { return glm::length(upper_ - lower_); }
    /// The eight cells that the bounding box is cut into by halving each of its sides: they leave about a box.
    [[nodiscard]] dvec3 octant() const { return glm::max(0.5 * (upper_ - lower_), dvec3(1e-6 * size())); }
    /// Positions of the original vertices, and the part of an original triangle.
    [[nodiscard]] const std::vector<dvec3>& positions() const { return positions_; }
    [[nodiscard]] std::uint32_t partOf(std::size_t triangle) const { return parts_[triangle]; }

private:
    /// An edge where the mesh or a part of it ends.
    struct Border {
        std::uint32_t from, to, triangle;
    };
    void findPieces();
    [[nodiscard]] std::vector<std::uint64_t> cellsOf(const dvec3& cell) const;
    [[nodiscard]] dvec3 latticeOrigin(const dvec3& cell) const;
    void placeVertices(ClusteredMesh& mesh, std::span<const std::uint64_t> cells, const dvec3& cell) const;

    const scene::Mesh& mesh_;
    std::vector<dvec3> positions_; ///< metres
    std::vector<std::uint32_t> parts_;
    std::vector<Border> borders_;
    std::vector<std::uint32_t> placeOfVertex_; ///< the first vertex at the same position
    std::vector<std::uint32_t> pieceOfVertex_; ///< the first vertex of its connected piece
    struct Piece {
        double area = 0; ///< m^2
        std::size_t triangles = 0;
    };
    std::vector<Piece> pieces_;     ///< by that vertex
    dvec3 lower_{0.0}, upper_{0.0}; ///< bounding box
};

} // namespace shadowlab::radiosity
