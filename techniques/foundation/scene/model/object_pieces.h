// One thing in several meshes.
//
// A mesh that is too wide for its detail is cut, because floats about one origin do not hold it (obj/mesh_pieces.h). Each piece is an
// object to all techniques. For the user they are one: the scene has them in a row, with one name and one placement.
// SPDX-License-Identifier: MIT
#pragma once
#include "techniques/foundation/scene/model/scene.h"

namespace shadowlab::scene {

/// Indices of objects, without `end`.
struct ObjectRange {
    std::size_t first = 0, end = 0;
};

/// All pieces of the thing that this object belongs to; mostly that object alone.
ObjectRange piecesOf(const Scene& scene, std::size_t object);

} // namespace shadowlab::scene
