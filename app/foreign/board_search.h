// Where in a picture the calibration board is: its orientation, and its scale along both axes, to some hundredths.
// SPDX-License-Identifier: MIT
#pragma once
#include "app/foreign/calibration_reading.h"

namespace shadowlab::foreign {

struct BoardMatch {
    Orientation orientation;
    dvec2 scale{1.0};    ///< of the picture put upright
    dvec2 shift{0.0};    ///< of it, right and down, shares of its width and height; 0 unless the board is not found without
    double likeness = 0; ///< correlation, -1 to 1
};

/// The picture has the board's size. Tries scales from a half to two, in square pictures turns by quarters, and where no
/// scale alone does, shifts by up to a quarter of the picture.
BoardMatch searchBoard(const image::Image& picture, const BoardLayout& board, ivec2 size);

} // namespace shadowlab::foreign
