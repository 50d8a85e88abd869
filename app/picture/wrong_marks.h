// How large wrong pixels are drawn. One pixel in a million cannot be seen from the last row of a lecture hall, and a good shadow
// map has no other errors: so a wrong pixel that stands alone is drawn as a square. What is counted stays the pixel.
//
// Where wrong pixels lie close together (acne, a shadow in the wrong place) they are seen as they are, and squares would fill
// the gaps between them: there each stays one pixel.
// No OpenGL, so that any thread can find them.
// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "techniques/foundation/math/types.h"

namespace shadowlab::picture {

/// A picture whose pixels are to be counted has marks of this width.
constexpr int kOnePixel = 1;

/// The width in pixels of the square that stands for a wrong pixel in a picture of that height: odd, so that the pixel is in its
/// middle, at least 5, and about 1/150 of the height.
int wideMark(int height);

struct WrongMarks {
    static constexpr std::int32_t kNone = -1;
    /// For each pixel the index of the wrong pixel in whose colour it is drawn, or kNone. Where squares meet it is the nearest
    /// one: so each wrong pixel keeps its own place, and two of different colours share what is between them.
    std::vector<std::int32_t> owner;
    int wide = 0, single = 0; ///< wrong pixels drawn as squares, and as they are
};

/// `isWrong` has an entry for each pixel, rows from the top. Squares end at the edges of the picture.
WrongMarks wrongMarks(const std::vector<std::uint8_t>& isWrong, ivec2 size, int width);

/// The line of the legend that says how wrong pixels are drawn. Empty when each is one pixel.
std::string noteOf(const WrongMarks& marks, int width);

} // namespace shadowlab::picture
