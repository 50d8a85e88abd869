// SPDX-License-Identifier: MIT
#include "techniques/foundation/image/picture_file.h"

#include <algorithm>
#include <array>
#include <string>
#include <utility>

#include "techniques/foundation/base/error.h"
#include "techniques/foundation/image/jpeg/jpeg.h"

namespace shadowlab::image {

namespace {

/// What files of other formats have at a place near their start. (TGA files have nothing of their own.)
struct OtherFormat {
    std::size_t at;
    std::string_view sign, name;
};
constexpr std::array kOtherFormats{OtherFormat{0, "BM", "BMP"},         OtherFormat{0, "GIF8", "GIF"},        OtherFormat{8, "WEBP", "WebP"},
                                   OtherFormat{0, "DDS ", "DDS"},       OtherFormat{0, "\xabKTX ", "KTX2"},   OtherFormat{4, "ftypavif", "AVIF"},
                                   OtherFormat{0, {"II*\0", 4}, "TIFF"}, OtherFormat{0, {"MM\0*", 4}, "TIFF"}, OtherFormat{0, "8BPS", "PSD"}};

std::string_view textOf(std::span<const std::uint8_t> bytes) { return {reinterpret_cast<const char*>(bytes.data()), bytes.size()}; }

/// The caller has seen that it is no JPEG.
void requirePng(std::span<const std::uint8_t> bytes, std::string_view name) {
    constexpr std::string_view kPng = "\x89PNG";
    if (textOf(bytes).starts_with(kPng)) return;
    const std::string_view other = otherFormat(textOf(bytes));
    throw Error(ExitStatus::badInput, std::string(name) + ": neither PNG nor JPEG" +
                                          (other.empty() ? "" : ", but seems to be " + std::string(other)) + "; save it as one of these");
}

} // namespace

std::string_view otherFormat(std::string_view bytes) {
    for (const OtherFormat& other : kOtherFormats)
        if (bytes.substr(std::min(other.at, bytes.size())).starts_with(other.sign)) return other.name;
    return {};
}

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
