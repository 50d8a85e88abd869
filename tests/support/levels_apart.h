// How far two pictures are from each other, in levels of 255.
// SPDX-License-Identifier: MIT
#pragma once
#include <algorithm>
#include <cstdlib>

#include "techniques/foundation/image/image.h"

namespace shadowlab::testing {

/// Of a pixel's four channels the one that differs most.
inline int levelsApart(image::Color8 a, image::Color8 b) {
    return std::max({std::abs(a.r - b.r), std::abs(a.g - b.g), std::abs(a.b - b.b), std::abs(a.a - b.a)});
}

/// How many pixels of two pictures of one size are more than `levels` apart.
inline int differingPixels(const image::Image& a, const image::Image& b, int levels) {
    int count = 0;
    for (int y = 0; y < a.height; ++y)
        for (int x = 0; x < a.width; ++x)
            count += levelsApart(a.at(x, y), b.at(x, y)) > levels;
    return count;
}

} // namespace shadowlab::testing
