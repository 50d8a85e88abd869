// Patches: faces cut into pieces small enough that one radiosity stands for each.
// SPDX-License-Identifier: MIT
#pragma once
#include <vector>

#include "techniques/radiosity/patches/faces.h"

namespace shadowlab::radiosity {

struct Patch {
    Polygon polygon; ///< centred space, counter-clockwise seen from the front
    dvec3 normal{0.0}, centre{0.0};
    double area = 0; ///< m^2
    std::uint32_t face = 0;
    [[nodiscard]] Plane plane() const { return {centre, normal}; }
};

/// The part of a patch that lies in the polygon.
Patch pieceOf(const Patch& patch, const Polygon& polygon);

/// No edge of a patch is longer than `size` metres. Quads become quads, as many along one pair of sides as along the other is
/// needed; triangles become triangles of their own shape.
std::vector<Patch> cutIntoPatches(const Faces& faces, double size);

/// The size at which there are at most that many patches, or as many as there are faces: the smallest of those that halving
/// the scene's extent in sixteenths of a doubling gives.
double sizeForBudget(const Faces& faces, std::size_t most);

} // namespace shadowlab::radiosity
