// SPDX-License-Identifier: MIT
#include "app/student/grading/picture_difference.h"

#include <cstdlib>

namespace shadowlab::student {

PictureDifference difference(const image::Image& picture, const image::Image& right, int levels) {
    PictureDifference result;
    for (std::size_t pixel = 0; pixel < right.rgba.size(); pixel += image::kChannels) {
        bool wrong = false;
        for (std::size_t channel = pixel; channel < pixel + 3; ++channel)
            wrong |= std::abs(int{picture.rgba[channel]} - int{right.rgba[channel]}) > levels;
        result.wrong.push_back(wrong);
        result.count += wrong;
    }
    return result;
}

} // namespace shadowlab::student
