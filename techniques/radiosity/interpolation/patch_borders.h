// The borders of patches, and which patches are neighbours.
//
// Patches of different sizes meet along parts of edges: the corner of one lies inside an edge of another (a T-vertex). Here such
// a corner is a point of both borders. Then every piece of a border has at most one patch on its other side, and what is
// interpolated between its two ends is the same from both sides (anchored T-vertices: D. Baum, S. Mann, K. Smith and J. Winget,
// "Making Radiosity Usable", SIGGRAPH 1991).
// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "techniques/radiosity/patches/patches.h"

namespace shadowlab::radiosity {

struct PatchBorders {
    static constexpr std::uint32_t kNone = ~std::uint32_t{0};

    /// A piece of a border, from its point to that of the next piece.
    struct Piece {
        std::uint32_t point;
        std::uint32_t patch;
        std::uint32_t across = kNone; ///< the same piece in the neighbour's border, if shading is continuous there
    };
    std::vector<dvec3> pointsCentred; ///< no two of one object in the same place
    std::vector<Piece> pieces;        ///< patch after patch, each counter-clockwise as its polygon
    std::vector<std::uint32_t> first; ///< first piece of each patch; one more entry than patches
    /// Pairs of patches that would be neighbours, but for a contact on their common line or on a part of it: the lower number
    /// first, sorted, each pair once.
    std::vector<std::pair<std::uint32_t, std::uint32_t>> parted;

    [[nodiscard]] std::span<const Piece> of(std::size_t patch) const {
        return {pieces.data() + first[patch], pieces.data() + first[patch + 1]};
    }
    /// The next piece of the same border.
    [[nodiscard]] std::uint32_t after(std::uint32_t piece) const {
        const std::uint32_t patch = pieces[piece].patch;
        return piece + 1 < first[patch + 1] ? piece + 1 : first[patch];
    }
    /// The patches across its border, each once, in order; also where a contact takes a part of the line.
    [[nodiscard]] std::vector<std::uint32_t> neighbours(std::size_t patch) const;
};

/// Shading is continuous between patches of one object and material that lie in one plane, or meet at less than 50 degrees, where
/// no other face touches their common line (contacts.h). A ball of eight segments has 45 degrees between its facets and is meant
/// to be round; a roof has 60, a box 90, and they are not.
PatchBorders patchBorders(const Faces& faces, const std::vector<Patch>& patches);

} // namespace shadowlab::radiosity
