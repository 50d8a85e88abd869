// The triangles of a mesh that can show their front to a point.
//
// Backs of a closed mesh are hidden by its fronts, and are culled. The rasteriser does that after it has transformed all corners; for a
// software renderer that is most of the cost of a small triangle. These lists leave out beforehand what it would cull. A graphics card
// culls faster than a processor makes a list, so there none is made.
// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <vector>

#include "techniques/foundation/gl/scene/mesh_buffers.h"
#include "techniques/foundation/scene/model/mesh.h"

namespace shadowlab::gl {

/// Do lists pay: does the driver draw on the processor, and is the mesh large?
bool paysToListFronts(const scene::Mesh& mesh);

/// The point of the mesh's space from which that projection looks: w = 1; or, of a parallel one, the unit direction toward the viewer: w = 0.
dvec4 viewerMesh(const dmat4& clipFromMesh);

/// The triangles, in the mesh's order, but for those that such a viewer sees from the back by more than a thousandth of a radian. (A
/// rasteriser moves corners to a grid within pixels, and so may take a triangle much smaller than a pixel for a front that is none. With
/// the list it is not drawn: the surface before it hides it.)
std::vector<std::uint32_t> frontTriangles(const scene::Mesh& mesh, const dvec4& viewerMesh);

/// They, on the graphics card.
class FrontTriangles {
public:
    /// The buffers of the mesh must outlive it.
    FrontTriangles(const scene::Mesh& mesh, const MeshBuffers& buffers, const dvec4& viewerMesh);
    [[nodiscard]] const dvec4& viewerMesh() const { return viewerMesh_; }
    /// Draws those of a run of triangles, counted in the mesh.
    void draw(std::uint32_t first, std::uint32_t count) const;
    /// As MeshBuffers::drawNumbered.
    void drawNumbered(std::uint32_t first, std::uint32_t count) const;
    /// As MeshBuffers::drawPositions.
    void drawPositions(std::uint32_t first, std::uint32_t count) const;

private:
    /// Counted in the list.
    struct Run {
        std::uint32_t first, count;
    };
    [[nodiscard]] Run listed(std::uint32_t first, std::uint32_t count) const;

    dvec4 viewerMesh_;
    OrderedTriangles triangles_; ///< in ascending order
};

} // namespace shadowlab::gl
