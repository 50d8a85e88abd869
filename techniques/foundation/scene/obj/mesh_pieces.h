// Where a mesh needs more than one origin, and which triangle belongs to which.
//
// A float that counts from an origin is wrong by at most 2^-24 of its size. So an origin holds a vertex if the vertex is not farther
// away than 2^14 times the shortest edge there: its error is then at most 2^-10 of that edge, less than a pixel where the edge is as
// long as a picture is wide. A stray vertex has long edges only and needs little; it may lie anywhere.
//
// The origin that every mesh gets (chooseOrigin) holds nearly all. Where it does not, as few others as are found take its place:
// connected parts that one origin holds together share it. A triangle that hangs on the detail and reaches far out of it is a piece of its
// own, about the same origin: its corners on the detail keep their bits, and the box around the detail stays small, which shadow maps and
// depth ranges are fitted to.
// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "techniques/foundation/math/types.h"

namespace shadowlab::scene {

/// One vertex in a hundred may have shorter edges: needles and crumbs, which exporters leave behind, ask for no precision of their own.
constexpr double kCrumbs = 0.01;

/// An origin holds what is at most this many of its shortest edges away.
constexpr double kReachInEdges = 0x1p14;

struct MeshPieces {
    std::vector<dvec3> origins;          ///< of each piece, the piece of the most triangles first; empty: `usual` holds the mesh
    std::vector<std::uint32_t> pieceOf; ///< of each triangle; empty: there is one piece
};

/// The triangles are corners as indices of positions. `usual` is the origin that the mesh has if it holds it.
MeshPieces meshPieces(std::span<const dvec3> positions, std::span<const uvec3> triangles, const dvec3& usual);

/// For each position, the first one with the same numbers.
std::vector<std::uint32_t> samePlaces(std::span<const dvec3> positions);

} // namespace shadowlab::scene
