// SPDX-License-Identifier: MIT
#include "techniques/foundation/image/picture_file.h"

#include <utility>

#include "techniques/foundation/image/jpeg/jpeg.h"

namespace shadowlab::image {

PngSize pictureSize(std::span<const std::uint8_t> bytes, std::string_view name, const PngLimits& limits) {
    return startsLikeJpeg(bytes) ? jpegSize(bytes, name, limits) : pngSize(bytes, name, limits);
}

PictureFile pictureFrom(std::span<const std::uint8_t> bytes, std::string_view name, const PngLimits& limits) {
    if (startsLikeJpeg(bytes)) return {decodeJpeg(bytes, name, limits), false};
    DecodedPng png = decodePng(bytes, name, limits);
    return {std::move(png.image), png.hasAlpha};
}

} // namespace shadowlab::image
