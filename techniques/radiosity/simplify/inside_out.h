// Turns inverted parts of simplified closed meshes outward again.
//
// In a wall thinner than a cell the two sides may change places: the outer one, simplified to fewer and longer chords, comes to
// lie inside the inner one. Then only the fronts lie between the two; they see nothing but each other and would stay black, and
// the room sees backs. Turned over, they are a wall again. The winding number (patches/winding_number.h) finds them: it should be
// 0 before every front, and is negative where the mesh is inside out.
// SPDX-License-Identifier: MIT
#pragma once
#include <vector>

#include "techniques/radiosity/simplify/vertex_clusters.h"

namespace shadowlab::radiosity {

/// Turns the triangles before whose front the winding number is negative at most places. The original mesh was closed, with its
/// fronts outside, or inside if it is mirrored. Where a turned triangle meets others, edges no longer match.
void orientOutward(ClusteredMesh& mesh, bool isMirrored);

} // namespace shadowlab::radiosity
