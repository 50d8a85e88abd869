// The faces of half a cube around the centre of a patch, and the delta form factor of each of its pixels.
//
// M. Cohen and D. Greenberg, "The Hemi-Cube: A Radiosity Solution for Complex Environments", SIGGRAPH 1985. All things that cover
// the same pixel have the same form factor. So it is enough to know, for every pixel, the share of the patch's light that passes
// through it (its delta form factor) and which patch is seen through it (hemicube.h).
//
// Hemicube space: origin at the centre, z along the patch's normal. The half cube extends from -1 to 1 in x and y, up to z = 1.
// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <vector>

#include "techniques/foundation/math/types.h"

namespace shadowlab::radiosity {

/// One face, as a camera at the origin sees it. Unit vectors in hemicube space.
struct HemicubeFace {
    dvec3 forward, up;
    int firstRow; ///< in the picture, in halves of `side`
    int rows;     ///< likewise
    [[nodiscard]] dvec3 right() const { return glm::cross(forward, up); }
};

/// The five faces lie one above the other in one picture, `side` pixels wide: the upper face, then the four sides, half as high,
/// which reach from the patch's plane upward. `side` is even.
inline constexpr std::array<HemicubeFace, 5> kHemicubeFaces = {{{{0, 0, 1}, {1, 0, 0}, 0, 2},
                                                                {{1, 0, 0}, {0, 0, 1}, 2, 1},
                                                                {{0, 1, 0}, {0, 0, 1}, 3, 1},
                                                                {{-1, 0, 0}, {0, 0, 1}, 4, 1},
                                                                {{0, -1, 0}, {0, 0, 1}, 5, 1}}};

/// Size of the whole picture, pixels.
inline ivec2 hemicubePicture(int side) { return {side, 3 * side}; }

/// The delta form factor of every pixel, row by row, row 0 at the bottom of the upper face, as GL counts. Each is exact for the
/// pixel as a rectangle, by Lambert's formula (point_form_factor.h), so they sum to 1. The usual formulas, 1 / (pi (x^2 + y^2 +
/// 1)^2) times the area for the upper face and z / (pi (y^2 + z^2 + 1)^2) for the sides, hold for the pixel's midpoint, and their
/// sum is not exactly 1.
std::vector<double> deltaFormFactors(int side);

} // namespace shadowlab::radiosity
