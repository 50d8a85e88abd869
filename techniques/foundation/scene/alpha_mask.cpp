// SPDX-License-Identifier: MIT
#include "techniques/foundation/scene/alpha_mask.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>

#include "techniques/foundation/error.h"
#include "techniques/foundation/image/output_file.h"
#include "techniques/foundation/image/png.h"
#include "techniques/foundation/scene/file_access.h"
#include "techniques/foundation/scene/load.h"

namespace shadowlab::scene {

namespace {

/// Is this texel solid? Alpha of at least one half of 255, or that much brightness; in whole numbers.
bool isSolid(const image::Color8& texel, bool hasAlpha) {
    if (hasAlpha) return 2 * texel.a >= 255;
    return 2 * (2126 * texel.r + 7152 * texel.g + 722 * texel.b) >= 255 * 10000;
}

/// 0 .. count - 1: in which of `count` equal pieces of the image the coordinate lies.
int pieceOf(double coordinate, int count) {
    const double within = coordinate - std::floor(coordinate);
    // Just below a whole number the difference rounds up to 1, which is the last piece and not the first.
    return std::min(static_cast<int>(within * count), count - 1);
}

} // namespace

AlphaMask::AlphaMask(const image::DecodedPng& png) : size_(png.image.width, png.image.height) {
    texels_.reserve(static_cast<std::size_t>(size_.x) * static_cast<std::size_t>(size_.y));
    for (int y = size_.y; y-- > 0;)
        for (int x = 0; x < size_.x; ++x)
            texels_.push_back(isSolid(png.image.at(x, y), png.hasAlpha) ? 255 : 0);
}

bool AlphaMask::isHole(dvec2 texcoord) const {
    const int column = pieceOf(texcoord.x, size_.x), row = pieceOf(texcoord.y, size_.y);
    return texels_[static_cast<std::size_t>(row) * static_cast<std::size_t>(size_.x) +
                   static_cast<std::size_t>(column)] == 0;
}

std::shared_ptr<const AlphaMask> AlphaMasks::load(const std::filesystem::path& canonical, const Limits& limits) {
    std::shared_ptr<const AlphaMask>& mask = known_[canonical];
    if (mask) return mask;
    const std::string text = readFile(canonical, limits.imageFileBytes, "image-file");
    const std::vector<std::uint8_t> bytes(text.begin(), text.end());
    constexpr std::string_view kNoName;
    try {
        mask = std::make_shared<const AlphaMask>(
            image::decodePng(bytes, kNoName, {.side = limits.imageSide, .fileBytes = limits.imageFileBytes}));
    } catch (const Error& error) {
        constexpr std::size_t kAfterColon = 2; // ": not a readable PNG ...", without a name before it
        throw Error(error.status(), std::string(error.what()).substr(kAfterColon) +
                                        (error.status() == ExitStatus::overLimit ? ", or set --limit image-side" : ""));
    }
    image::keepInput(canonical);
    return mask;
}

} // namespace shadowlab::scene
