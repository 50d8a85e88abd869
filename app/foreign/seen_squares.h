// The calibration board's squares in a picture: where each is seen, if all of it is, and how the board lies by them.
// SPDX-License-Identifier: MIT
#pragma once
#include <optional>
#include <vector>

#include "app/foreign/calibration_board.h"
#include "techniques/foundation/image/image.h"

namespace shadowlab::foreign {

/// Where the board's middle and axes are seen, in pixels.
struct Placement {
    dvec2 centrePx{0.0};
    dvec2 perX{1.0, 0.0}, perY{0.0, 1.0}; ///< what a pixel of the board to the right, and down, is in the picture
    [[nodiscard]] dvec2 operator()(const dvec2& fromMiddlePx) const {
        return centrePx + fromMiddlePx.x * perX + fromMiddlePx.y * perY;
    }
};

struct SeenSquare {
    std::size_t index = 0; ///< of BoardLayout::squares
    dvec2 boardPx{0.0}, seenPx{0.0}; ///< its middle, from the middle of the board, and in the picture
};

/// Those of the squares that are seen as a whole near where `placed` has them, give or take `marginPx`. One that the picture's edge
/// cuts, or comes nearer to than a pixel, is left out: its centre of gravity is not its middle. So are small ones of less than
/// five pixels.
std::vector<SeenSquare> wholeSquares(const image::Image& picture, const BoardLayout& board, ivec2 size, const Placement& placed, double marginPx);

/// Least squares: seen = centre + x perX + y perY. Nothing where the squares are too few, or lie too much on one line, for the picture's
/// corners to be known to the third of a pixel that a fault is told from.
std::optional<Placement> fitted(const std::vector<SeenSquare>& seen, ivec2 size);

/// Of the large squares alone, which are measured better, where all four are whole; else of all.
std::vector<SeenSquare> bestOf(const std::vector<SeenSquare>& seen);

/// The largest distance of a square from where the placement has it, pixels.
double worstMissPx(const std::vector<SeenSquare>& seen, const Placement& placed);

} // namespace shadowlab::foreign
