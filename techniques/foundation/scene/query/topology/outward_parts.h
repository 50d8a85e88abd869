// The parts of a mesh in which front faces hide all back faces. The back faces then need not be drawn for the eye, and
// front faces alone block a light: half of the caps of a shadow volume, and silhouette edges extruded once instead of
// twice.
//
// Behind a part of a mesh with these three properties there is no back face without a front face before it:
//   - closed and consistently wound, so that it has a winding number w at every point, and on the way from a point to the
//     eye or the light w(there) = w(point) - front faces + back faces;
//   - w >= 0 everywhere: nothing of it is inside out;
//   - eye or light are outside: w(there) = 0.
// The second property is the hard one: a closed surface that intersects itself may be inside out in places, whatever its
// volume. The first test is whether the part can be contracted, straight toward a point, a line or a plane, so that each
// triangle moves with its inside ahead: then w counts the triangles that sweep over a point, and no count is negative.
// Boxes, spheres, tori and columns pass this test. For all others the test is whether they intersect themselves at all
// (simple_surface.h): a knot does not, and its signed volume shows that it is not inside out as a whole. Surfaces that
// intersect themselves use the general form.
// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "techniques/foundation/scene/model/mesh.h"
#include "techniques/foundation/scene/query/topology/mesh_topology.h"

namespace shadowlab::scene {

/// The parts of a mesh (components connected by edges) that have the three properties.
struct OutwardParts {
    static constexpr std::int32_t kNone = -1;
    struct Box {
        dvec3 lowerMesh{1e300}, upperMesh{-1e300};
    };
    std::vector<std::int32_t> partOfTriangle; ///< kNone where it is not shown that w >= 0
    std::vector<Box> boxes;                   ///< of each part
};

OutwardParts outwardParts(const Mesh& mesh, const MeshTopology& topology);

/// True if the whole mesh has the three properties; the value of Mesh::outward.
bool isOutward(const Mesh& mesh);

/// The mesh, shared, with `outward` computed: loaders and builders of meshes end with this.
std::shared_ptr<const Mesh> sharedMesh(Mesh mesh);

/// Sets the sign of back faces (-1) to zero in all parts with the light outside: in front of their box, on any side.
/// `lightMesh` is homogeneous (scene/query/facing.h).
void keepFrontFacesAlone(std::span<std::int8_t> facing, const OutwardParts& parts, const dvec4& lightMesh);

} // namespace shadowlab::scene
