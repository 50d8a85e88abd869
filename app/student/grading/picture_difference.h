// Where two pictures differ by more than a few levels.
// SPDX-License-Identifier: MIT
#pragma once
#include <vector>

#include "techniques/foundation/image/image.h"

namespace shadowlab::student {

struct PictureDifference {
    std::vector<bool> wrong; ///< per pixel, rows from the top
    int count = 0;           ///< of wrong ones
};

/// A pixel is wrong if a channel differs by more than `levels` of 255, as the pictures are encoded (sRGB). They have one size.
PictureDifference difference(const image::Image& picture, const image::Image& right, int levels);

} // namespace shadowlab::student
