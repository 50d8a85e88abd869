// SPDX-License-Identifier: MIT
#include "techniques/foundation/image/picture_file.h"

#include <array>
#include <string>
#include <utility>

#include "techniques/foundation/base/error.h"
#include "techniques/foundation/image/jpeg/jpeg.h"

namespace shadowlab::image {

namespace {

/// How files of other formats start that are found among textures. (TGA files start with nothing of their own.)
struct OtherFormat {
    std::string_view start, name;
};
constexpr std::array kOtherFormats{OtherFormat{"BM", "BMP"},  OtherFormat{"GIF8", "GIF"},         OtherFormat{"RIFF", "WebP"},
                                   OtherFormat{"DDS ", "DDS"}, OtherFormat{{"II*\0", 4}, "TIFF"}, OtherFormat{{"MM\0*", 4}, "TIFF"},
                                   OtherFormat{"8BPS", "PSD"}};

/// The caller has seen that it is no JPEG.
void requirePng(std::span<const std::uint8_t> bytes, std::string_view name) {
    constexpr std::string_view kPng = "\x89PNG";
    const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    if (text.starts_with(kPng)) return;
    std::string format;
    for (const OtherFormat& other : kOtherFormats)
        if (text.starts_with(other.start)) format = ", but seems to be " + std::string(other.name);
    throw Error(ExitStatus::badInput, std::string(name) + ": neither PNG nor JPEG" + format + "; save it as one of these");
}

} // namespace

PngSize pictureSize(std::span<const std::uint8_t> bytes, std::string_view name, const PngLimits& limits) {
    if (startsLikeJpeg(bytes)) return jpegSize(bytes, name, limits);
    requirePng(bytes, name);
    return pngSize(bytes, name, limits);
}

PictureFile pictureFrom(std::span<const std::uint8_t> bytes, std::string_view name, const PngLimits& limits) {
    if (startsLikeJpeg(bytes)) return {decodeJpeg(bytes, name, limits), false};
    requirePng(bytes, name);
    DecodedPng png = decodePng(bytes, name, limits);
    return {std::move(png.image), png.hasAlpha};
}

} // namespace shadowlab::image
