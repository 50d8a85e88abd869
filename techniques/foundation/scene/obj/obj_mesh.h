// From checked polygons to a Mesh: origin, rounding to float, triangulation, normals, parts, shared vertices.
// SPDX-License-Identifier: MIT
#pragma once
#include <vector>

#include "techniques/foundation/scene/model/mesh.h"
#include "techniques/foundation/scene/model/shapes.h"
#include "techniques/foundation/scene/obj/obj_faces.h"

namespace shadowlab::scene {

/// Normals as the file has them (a corner without one gets that of its smoothing group, or of no group the flat one of its triangle),
/// or as `mode` asks. One mesh; several where floats about one origin do not hold it (mesh_pieces.h), with the most triangles first.
std::vector<Mesh> buildMeshes(const ObjScan& scan, const ObjFaces& faces, NormalMode mode);

/// The point that is subtracted from a mesh before rounding to float: zero unless the box lies so far out that float
/// would lose its detail. A multiple of a power of two near the box's size, so that the subtraction is exact.
dvec3 chooseOrigin(const dvec3& lower, const dvec3& upper);

} // namespace shadowlab::scene
