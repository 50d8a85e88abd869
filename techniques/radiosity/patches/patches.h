// Patches: faces cut into pieces so small that one radiosity stands for each.
// SPDX-License-Identifier: MIT
#pragma once
#include <vector>

#include "techniques/radiosity/patches/faces.h"
#include "techniques/radiosity/patches/ground.h"

namespace shadowlab::radiosity {

struct Patch {
    Polygon polygon; ///< centred space, counter-clockwise seen from the front
    dvec3 normal{0.0}, centre{0.0};
    double area = 0; ///< m^2
    std::uint32_t face = 0;
    [[nodiscard]] Plane plane() const { return {centre, normal}; }
};

/// A part of a face that is cut evenly: with edges as long as elsewhere, doubled so often.
struct FacePart {
    Polygon polygon;
    int doublings = 0;
};
/// Of each face; where there are none, or no such face, it is cut as a whole.
using FaceParts = std::vector<std::vector<FacePart>>;

/// All of a face.
Patch wholePatch(const Face& face, std::uint32_t number);
/// The part of a patch inside the polygon.
Patch pieceOf(const Patch& patch, const Polygon& polygon);

/// Quads and triangles in four of their shape, quads more than twice as long as wide in two, and other polygons by two lines through the
/// centre, along the longest edge and perpendicular to it. The patch itself if a piece would be too small to have an area.
std::vector<Polygon> dividedPatch(const Patch& patch);

/// Cuts faces such that no edge of a patch is longer than `size` metres, of a ground and of parts that may be coarser longer than is right there.
/// Quads become grids of quads, triangles become triangles of their own shape.
std::vector<Patch> cutIntoPatches(const Faces& faces, double size, const Ground& ground = {}, const FaceParts& parts = {});

/// The smallest size that leaves at most `most` patches (or one per face), among the longest edge times 2^(-k/16), k = 0, 1, 2
/// ...
double sizeForBudget(const Faces& faces, std::size_t most, const Ground& ground = {}, const FaceParts& parts = {});

} // namespace shadowlab::radiosity
