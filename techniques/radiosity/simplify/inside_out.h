// Closed meshes that were made coarser, turned right side out again.
//
// Walls thinner than a cell may change places: the outer one, drawn with fewer and longer chords, comes to lie within the inner
// one. Between them then are only fronts, which see nothing but each other and would stay black, and the room sees backs. Turned
// round, they are a wall again. The winding number (winding.h) tells where: it is 0 outside, as it should be before every front;
// where a mesh is inside out it is negative.
// SPDX-License-Identifier: MIT
#pragma once
#include <vector>

#include "techniques/radiosity/simplify/vertex_clusters.h"

namespace shadowlab::radiosity {

/// Turns the triangles that have most of their front where the winding number is negative. The mesh was closed, with its fronts
/// outside, or, mirrored, inside; its edges do not fit together any more where a turned triangle meets others.
void orientOutward(ClusteredMesh& mesh, bool isMirrored);

} // namespace shadowlab::radiosity
