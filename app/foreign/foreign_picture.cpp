// SPDX-License-Identifier: MIT
#include "app/foreign/foreign_picture.h"

#include <algorithm>
#include <string>

#include "app/picture/limits.h"
#include "techniques/foundation/base/error.h"
#include "techniques/foundation/image/png/png.h"
#include "techniques/foundation/scene/load/message_text.h"

namespace shadowlab::foreign {

image::Image loadForeign(const std::filesystem::path& file) {
    image::PngLimits limits;
    limits.side = picture::pictureLimits().measuredSide;
    limits.withTexts = false;
    return image::loadPng(file, limits);
}

bool isGrey(const image::Image& picture) {
    constexpr int kRounding = 2;
    for (std::size_t i = 0; i < picture.rgba.size(); i += image::kChannels) {
        const std::uint8_t* const p = picture.rgba.data() + i;
        if (p[3] > 0 && std::max({p[0], p[1], p[2]}) - std::min({p[0], p[1], p[2]}) > kRounding) return false;
    }
    return true;
}

bool hasTransparency(const image::Image& picture) {
    for (std::size_t i = 3; i < picture.rgba.size(); i += image::kChannels)
        if (picture.rgba[i] < 255) return true;
    return false;
}

void requireSameSize(const image::Image& picture, const std::filesystem::path& file, ivec2 size, const std::string& asWhat) {
    if (picture.width == size.x && picture.height == size.y) return;
    const auto text = [](int width, int height) { return std::to_string(width) + " x " + std::to_string(height); };
    throw Error(ExitStatus::badInput, scene::shownPath(file) + ": has " + text(picture.width, picture.height) + " pixels, but " + asWhat +
                                          " has " + text(size.x, size.y) + "; draw both with one camera in one size");
}

} // namespace shadowlab::foreign
