// A ground that reaches far beyond all that stands on it.
//
// Cut as fine as the rest, it would take nearly all patches, and most of them for places where nothing changes: what is reflected onto it
// falls off with the square of the distance. So its patches grow with the distance from what stands on it: a ground of any size then
// costs about the same (the grading of hierarchical radiosity, by distance alone: P. Hanrahan, D. Salzman and L. Aupperle, "A Rapid
// Hierarchical Radiosity Algorithm", SIGGRAPH 1991).
// SPDX-License-Identifier: MIT
#pragma once
#include <vector>

#include "techniques/radiosity/patches/faces.h"

namespace shadowlab::radiosity {

class Ground {
public:
    /// None: nothing is coarser than the rest.
    Ground() = default;
    /// Looks for one: faces in one plane, of objects many times as large as all others together.
    explicit Ground(const Faces& faces);

    [[nodiscard]] bool holds(std::uint32_t face) const { return face < isGround_.size() && isGround_[face]; }
    /// How long edges of a piece of ground may be, metres, where those of all else are at most `size`.
    [[nodiscard]] double sizeAt(const Polygon& piece, double size) const;

private:
    std::vector<bool> isGround_; ///< of each face; empty: there is none
    trace::CentredBox rest_;     ///< around all other faces
};

} // namespace shadowlab::radiosity
