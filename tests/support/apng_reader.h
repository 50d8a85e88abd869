// Reads animated PNGs strictly, by the specification and nothing of the program's own but its pictures: for tests.
// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <vector>

#include "techniques/foundation/image/png/animated_png.h"

namespace shadowlab::testing {

struct ApngFrame {
    image::ChangedPart part;
    unsigned delayNumerator = 0, delayDenominator = 0;
    image::Image shown; ///< the whole picture while this frame is on show
};

struct Apng {
    int width = 0, height = 0;
    unsigned plays = 0;
    std::vector<ApngFrame> frames;
};

/// 8-bit RGB without interlacing, first frame in IDAT, dispose NONE, blend SOURCE. Throws std::runtime_error for everything else:
/// a wrong check sum, an order of chunks or a sequence number that the specification does not allow, too few or too many pixels.
Apng readApng(const std::vector<std::uint8_t>& bytes);

} // namespace shadowlab::testing
