// From checked polygons to a Mesh: origin, rounding to float, triangulation, normals, parts, shared vertices.
// SPDX-License-Identifier: MIT
#pragma once
#include "techniques/foundation/scene/model/mesh.h"
#include "techniques/foundation/scene/obj/obj_faces.h"

namespace shadowlab::scene {

/// Normals as the file has them; a corner without one gets that of its smoothing group, or of no group the flat one of its triangle.
Mesh buildMesh(const ObjScan& scan, const ObjFaces& faces);

/// The point that is subtracted from a mesh before rounding to float: zero unless the box lies so far out that float
/// would lose its detail. A multiple of a power of two near the box's size, so that the subtraction is exact.
dvec3 chooseOrigin(const dvec3& lower, const dvec3& upper);

} // namespace shadowlab::scene
