// Half a cube around the centre of a patch, and what share of the patch's light goes through each of its pixels.
//
// M. Cohen and D. Greenberg, "The Hemi-Cube: A Radiosity Solution for Complex Environments", SIGGRAPH 1985. All things that cover
// the same pixel have the same form factor, whatever they are: so it is enough to know that of every pixel, its delta form factor,
// and which patch is seen through it (hemicube.h).
//
// Hemicube space: origin at the centre, z along the patch's normal. The half cube goes from -1 to 1 in x and y, and up to z = 1.
// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <vector>

#include "techniques/foundation/math/types.h"

namespace shadowlab::radiosity {

/// One face, as a camera at the origin sees it. Unit vectors of hemicube space.
struct HemicubeFace {
    dvec3 forward, up;
    int firstRow; ///< in the picture, in halves of `side`
    int rows;     ///< likewise
    [[nodiscard]] dvec3 right() const { return glm::cross(forward, up); }
};

/// The five faces lie above each other in one picture, `side` pixels wide: the upper one, then the sides, half as high, that reach
/// from the patch's own plane upward. `side` is even.
inline constexpr std::array<HemicubeFace, 5> kHemicubeFaces = {{{{0, 0, 1}, {1, 0, 0}, 0, 2},
                                                                {{1, 0, 0}, {0, 0, 1}, 2, 1},
                                                                {{0, 1, 0}, {0, 0, 1}, 3, 1},
                                                                {{-1, 0, 0}, {0, 0, 1}, 4, 1},
                                                                {{0, -1, 0}, {0, 0, 1}, 5, 1}}};

/// Pixels of the whole picture.
inline ivec2 hemicubePicture(int side) { return {side, 3 * side}; }

/// The delta form factor of every pixel, row by row, row 0 at the bottom of the upper face, as GL counts. Each is that of the pixel
/// as a rectangle, exactly, by Lambert's formula (point_form_factor.h), so they sum to 1. The usual formulas, 1 / (pi (x^2 + y^2 + 1)^2)
/// times the area for the upper face and z / (pi (y^2 + z^2 + 1)^2) for the others, are those of the pixel's midpoint, and do not.
std::vector<double> deltaFormFactors(int side);

} // namespace shadowlab::radiosity
