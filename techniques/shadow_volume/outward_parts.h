// Where front faces alone make the volume: half of the caps, and every silhouette edge extruded once instead of twice.
//
// A count of front faces is zero where the light is blocked by back faces alone. That cannot be behind a part of the mesh
// with these three properties:
//   - closed and consistently wound, so that it has a winding number w at every point, and on the way from a point to the
//     light w(light) = w(point) - front faces + back faces;
//   - w >= 0 everywhere: nothing of it is inside out;
//   - the light is outside: w(light) = 0.
// Then without front faces there are no back faces either. The middle one is the hard one: a closed surface that
// intersects itself may be inside out in places, whatever its volume is. What is shown here instead is that the part can be
// drawn together, straight toward a point, a line or a plane, so that each triangle sweeps over space with its inside ahead:
// w counts the triangles that sweep over a point, and no count is negative. Boxes, spheres, tori and columns pass; a
// knot does not, though it is simple, and pays for the general form.
// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "techniques/foundation/scene/mesh.h"
#include "techniques/foundation/scene/mesh_topology.h"

namespace shadowlab::shadow_volume {

/// The parts of a mesh (pieces that hang together by edges) that pass.
struct OutwardParts {
    static constexpr std::int32_t kNone = -1;
    struct Box {
        dvec3 lowerMesh{1e300}, upperMesh{-1e300};
    };
    std::vector<std::int32_t> partOfTriangle; ///< kNone where it is not shown that w >= 0
    std::vector<Box> boxes;                   ///< of each part
};

OutwardParts outwardParts(const scene::Mesh& mesh, const scene::MeshTopology& topology);

/// Sets the sign of back faces (-1) to zero in all parts with the light outside: in front of their box, on any side.
/// `lightMesh` is homogeneous (scene/facing.h).
void keepFrontFacesAlone(std::span<std::int8_t> facing, const OutwardParts& parts, const dvec4& lightMesh);

} // namespace shadowlab::shadow_volume
