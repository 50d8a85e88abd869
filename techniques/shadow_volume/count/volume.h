// The shadow volume of one caster for one light, as indices into two kinds of vertices. Knows no graphics API.
//
// Works for any set of triangles: closed, open, non-manifold, inconsistently wound. Every triangle is oriented toward the
// light. At an edge the triangles then run in one direction or the other; the edge is extruded as often as these directions
// fail to cancel. The resulting surface is closed (the boundary of a boundary is empty), so a stencil counts the triangles
// between a point and the light. Sources: Crow, "Shadow Algorithms for Computer Graphics", 1977; Bergeron, "A General
// Version of Crow's Shadow Volumes", 1986 (open meshes); Aldridge and Woods, "Robust, Geometry-Independent Shadow Volumes",
// 2004 (signed edge counts).
// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "techniques/foundation/scene/model/mesh.h"
#include "techniques/shadow_volume/count/edge_table.h"

namespace shadowlab::shadow_volume {

/// A silhouette edge as the light sees it, directed so that the triangle turned toward the light runs a -> b.
struct SilhouetteEdge {
    std::uint32_t a = 0, b = 0;     ///< vertex indices of the mesh
    std::uint32_t multiplicity = 1; ///< how often it is extruded
    std::uint32_t triangles = 2;    ///< how many meet here: 1 is a boundary, more than 2 a non-manifold edge
    friend bool operator==(const SilhouetteEdge&, const SilhouetteEdge&) = default;
};

/// Triangle lists over 2 n vertices: index v is vertex v itself, index v + n is v pushed away from the light, to the
/// volume's end. Triangles are counter-clockwise seen from outside the volume.
struct Volume {
    std::vector<std::uint32_t> topCap;         ///< triangles with sign +1, in the mesh's own order and corner order
    std::vector<std::uint32_t> topCapReversed; ///< triangles with sign -1, likewise: these are clockwise from outside
    /// Extruded silhouette edges: of each quad one triangle in the first half of the list, which has one far vertex, and
    /// one in the second half, which has two and is degenerate where all far vertices are one point.
    std::vector<std::uint32_t> sides;
    std::vector<std::uint32_t> bottomCap; ///< the triangles of both top caps, at the end
};

/// Makes the silhouette, the edges whose triangles do not cancel once each is turned toward the light, and the volume, in
/// one pass over the edges and one over the triangles. `facing` is one sign per triangle (scene/query/facing.h); a triangle
/// with sign 0 is seen edge-on, covers nothing, and is left out. The previous contents of `silhouette` and `volume` are
/// replaced; their memory is reused.
void buildVolume(const scene::Mesh& mesh, const EdgeTable& edges, std::span<const std::int8_t> facing,
                 std::vector<SilhouetteEdge>& silhouette, Volume& volume);

/// The volume as the lecture builds it (lecture_volume.cpp), in place of buildVolume(): right for closed meshes only. A
/// triangle with sign 0 counts as facing away, since N.L > 0 is false.
void buildLectureVolume(const scene::Mesh& mesh, const EdgeTable& edges, std::span<const std::int8_t> facing,
                        std::vector<SilhouetteEdge>& silhouette, Volume& volume);

} // namespace shadowlab::shadow_volume
