// The borders of patches: who is whose neighbour.
//
// Patches of different sizes meet along parts of edges: the corner of one lies within the edge of another (a T-vertex). Such
// corners belong to both borders here. Then a piece of a border has at most one patch on its other side, and what is
// interpolated between its two ends is the same from both (the anchored T-vertices of D. Baum, S. Mann, K. Smith and J. Winget,
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

    /// A piece of a border, from its point to that of the next.
    struct Piece {
        std::uint32_t point;
        std::uint32_t patch;
        std::uint32_t across =
            kNone; ///< the same piece in the border of the patch beyond it, where light goes on smoothly
    };
    std::vector<dvec3> pointsCentred; ///< no two of one object in the same place
    std::vector<Piece> pieces;        ///< of one patch after the other, each counter-clockwise as its polygon
    std::vector<std::uint32_t> first; ///< of each patch; one more than patches
    /// Patches that would be neighbours, were it not for something that stands on the line between them or on a part of it: the
    /// lower number first, in order, each pair once.
    std::vector<std::pair<std::uint32_t, std::uint32_t>> parted;

    [[nodiscard]] std::span<const Piece> of(std::size_t patch) const {
        return {pieces.data() + first[patch], pieces.data() + first[patch + 1]};
    }
    /// The piece of the same patch that begins where that one ends.
    [[nodiscard]] std::uint32_t after(std::uint32_t piece) const {
        const std::uint32_t patch = pieces[piece].patch;
        return piece + 1 < first[patch + 1] ? piece + 1 : first[patch];
    }
    /// The patches beyond its border, each once, by their numbers; also where a part of the line is taken.
    [[nodiscard]] std::vector<std::uint32_t> neighbours(std::size_t patch) const;
};

/// Light goes on smoothly from patch to patch of one object and material that lie in one plane, or meet at less than 50 degrees,
/// where nothing stands on the line between them (contacts.h). A ball of eight segments has 45 degrees between its facets and is
/// meant to be round; a roof has 60, a box 90, and they are not.
PatchBorders patchBorders(const Faces& faces, const std::vector<Patch>& patches);

} // namespace shadowlab::radiosity
