// Radiosity at the corners of patches, for interpolation: each patch is drawn as a fan of triangles from its centre, where its
// own radiosity holds, to the points of its border.
//
// The solution has one radiosity per patch, and the eye exaggerates the steps between them (Mach bands). At a corner that is
// surrounded by patches, the value is that of the linear function which best fits theirs. At the rim of a surface, and along a
// wall that stands on it, patches lie on one side only. Their mean would be the value some way inside, which flattens the light
// there; so the linear function is extrapolated to the corner, from these patches and their neighbours (M. Cohen and J. Wallace,
// "Radiosity and Realistic Image Synthesis", 1993, do the same on regular grids).
// SPDX-License-Identifier: MIT
#pragma once
#include "techniques/radiosity/interpolation/patch_borders.h"

namespace shadowlab::radiosity {

struct PatchCorners {
    PatchBorders borders;
    std::vector<std::uint32_t> cornerOfPiece; ///< the corner at the first point of each piece of border
    /// The value at corner k is the sum of weights[first[k]] to weights[first[k + 1] - 1]. They sum to 1; some are negative.
    struct Weight {
        std::uint32_t patch;
        double weight;
    };
    std::vector<Weight> weights;
    std::vector<std::uint32_t> first; ///< first weight of each corner; one more entry than corners

    /// The number of corners. A place has as many corners as it has values: those of two walls that meet, or of the two sides of
    /// a partition, differ.
    [[nodiscard]] std::size_t count() const { return first.size() - 1; }

    /// The values at all corners, from one value for each patch and colour, W/m^2. Linear functions on a plane are reproduced
    /// exactly. No value is negative, or farther beyond the values it is made from than these differ among themselves.
    [[nodiscard]] std::vector<dvec3> values(std::span<const dvec3> ofPatches) const;
};

PatchCorners patchCorners(const Faces& faces, const std::vector<Patch>& patches);

} // namespace shadowlab::radiosity
