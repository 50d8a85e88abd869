// One mesh made coarser: all vertices in one cell of a lattice become one.
//
// A triangle whose corners so fall together vanishes; the others span from cell to cell. The one vertex of a cell lies where the
// sum of squared distances to the planes of the triangles that end there is least, each counted by the square of its area: on edges
// and corners of the surface, if it has any, and on average as much before the surface as behind. P. Lindstrom, "Out-of-Core
// Simplification of Large Polygonal Models", SIGGRAPH 2000; vertex clustering goes back to J. Rossignac and P. Borrel, 1993. Where
// the mesh, or one of its parts, ends, there is one more plane through the edge, across the triangle, so that outlines stay. Pieces of
// the mesh that hang together and have no more triangles than cells would leave of their area stay as they are: the top of a
// table, thinner than a cell, would vanish.
// SPDX-License-Identifier: MIT
#pragma once
#include <span>
#include <vector>

#include "techniques/foundation/scene/model/scene.h"

namespace shadowlab::radiosity {

/// Positions are in metres, along the world's axes, from the object's own origin.
struct ClusteredMesh {
    std::vector<dvec3> positions;
    std::vector<uvec3> triangles;
    std::vector<std::uint32_t> parts;           ///< of each triangle: the mesh part of the triangle that it was
    std::vector<std::uint32_t> clusterOfVertex; ///< of each vertex of the original: its one vertex in `positions`
};

class VertexClusters {
public:
    /// The object's mesh must live as long.
    explicit VertexClusters(const scene::Object& object);

    /// How many triangles remain with cells of that size in metres; those that fall together are counted more than once.
    [[nodiscard]] std::size_t roughCount(double cell) const;
    /// Of triangles that fall together one is left for all that face the same way, less those that face the other; both where the
    /// two sides of a thin sheet fall together. Those that are no wider than a thousandth of their length are left out: their third
    /// corner lies on a side, so no gap opens, but their normal would be chance.
    [[nodiscard]] ClusteredMesh clustered(double cell) const;

    /// The diagonal of the box around the mesh, in metres. With cells as large as that nothing remains.
    [[nodiscard]] double size() const { return glm::length(upper_ - lower_); }
    /// Of the vertices and triangles of the original.
    [[nodiscard]] const std::vector<dvec3>& positions() const { return positions_; }
    [[nodiscard]] std::uint32_t partOf(std::size_t triangle) const { return parts_[triangle]; }

private:
    /// A side at which the mesh or a part of it ends.
    struct Border {
        std::uint32_t from, to, triangle;
    };
    void findPieces();
    [[nodiscard]] std::vector<std::uint64_t> cellsOf(double cell) const;
    [[nodiscard]] dvec3 latticeOrigin(double cell) const;
    void placeVertices(ClusteredMesh& mesh, std::span<const std::uint64_t> cells, double cell) const;

    const scene::Mesh& mesh_;
    std::vector<dvec3> positions_; ///< metres
    std::vector<std::uint32_t> parts_;
    std::vector<Border> borders_;
    std::vector<std::uint32_t> placeOfVertex_; ///< the first vertex in the same place
    std::vector<std::uint32_t> pieceOfVertex_; ///< the first vertex of the piece of the mesh that it belongs to
    struct Piece {
        double area = 0; ///< m^2
        std::size_t triangles = 0;
    };
    std::vector<Piece> pieces_;     ///< by that vertex
    dvec3 lower_{0.0}, upper_{0.0}; ///< of the box around them
};

} // namespace shadowlab::radiosity
