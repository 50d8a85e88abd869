// Radiosity at the corners of patches, to be interpolated between: each patch is drawn as a fan of triangles from its centre,
// where its own radiosity is, to the points of its border.
//
// A solution has one radiosity for each patch; the eye sees every step between them, and stronger than they are (Mach bands).
// At a corner that patches surround on all sides, the value is that of the linear function which fits theirs best. At the rim
// of a surface, and along a wall that stands on it, patches lie on one side only. Their mean would be the value some way inside,
// and flatten the light there; so the function is carried on to the corner, from these patches and those next to them
// (M. Cohen and J. Wallace, "Radiosity and Realistic Image Synthesis", 1993, do the same on regular grids).
// SPDX-License-Identifier: MIT
#pragma once
#include "techniques/radiosity/interpolation/patch_borders.h"

namespace shadowlab::radiosity {

struct PatchCorners {
    PatchBorders borders;
    std::vector<std::uint32_t> cornerOfPiece; ///< which corner is at the first point of each piece of border
    /// Corner k takes its value from weights[first[k]] to weights[first[k + 1]]. They sum to 1; some are below 0.
    struct Weight {
        std::uint32_t patch;
        double weight;
    };
    std::vector<Weight> weights;
    std::vector<std::uint32_t> first; ///< of each corner; one more than corners

    /// How many corners there are. In one place there are as many as there are values: those of two walls that meet, or of
    /// the two sides of a partition, are not one.
    [[nodiscard]] std::size_t count() const { return first.size() - 1; }

    /// At each corner, from one number for each patch and colour, W/m^2. Linear functions on a plane surface are met exactly.
    /// Nothing goes below 0, or beyond the numbers of the patches it is made from by more than they differ.
    [[nodiscard]] std::vector<dvec3> values(std::span<const dvec3> ofPatches) const;
};

PatchCorners patchCorners(const Faces& faces, const std::vector<Patch>& patches);

} // namespace shadowlab::radiosity
