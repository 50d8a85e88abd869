// PNG in and out through libpng's full interface (its simplified one cannot write text chunks).
// The same picture and text give the same bytes: no time stamps, fixed compression settings.
// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "techniques/foundation/image/image.h"

namespace shadowlab::image {

/// A text chunk: `key` 1 to 79 printable Latin-1 characters ("Title", "Software" ...), `value` UTF-8.
struct PngText {
    std::string key, value;
    friend bool operator==(const PngText&, const PngText&) = default;
};

struct PngOptions {
    bool opaque = true; ///< write RGB and drop alpha, as every capture but the visibility stage does
    std::vector<PngText> text;
};

/// RGB or RGBA with an sRGB chunk.
std::vector<std::uint8_t> encodePng(const Image& image, const PngOptions& options = {});

/// 8-bit grey + alpha: `greyAlpha` holds width * height pairs, row 0 on top. The visibility image: its numbers are
/// measured fractions and not colours, so it carries no sRGB chunk.
std::vector<std::uint8_t> encodeGreyAlpha(int width, int height, std::span<const std::uint8_t> greyAlpha,
                                          const std::vector<PngText>& text = {});

/// What decoding refuses to go beyond (exit status 6). 16384 is the texture limit of Mesa's software renderers.
struct PngLimits {
    std::uint32_t side = 16384;             ///< pixels, each of width and height
    std::uint64_t fileBytes = 256ull << 20; ///< enough for an incompressible 8192 x 8192 RGB picture
    bool withTexts = true;                  ///< else they are skipped: a kilobyte of compressed text may unpack to megabytes
};

struct DecodedPng {
    Image image;           ///< whatever the file holds, widened or narrowed to 8-bit RGBA
    bool hasAlpha = false; ///< the file has an alpha channel; else alpha is 255 everywhere
    std::vector<PngText> text;
};

struct PngSize {
    std::uint32_t width = 0, height = 0;
};
/// Reads only the header; allocates nothing for the pixels. Throws as decodePng does.
PngSize pngSize(std::span<const std::uint8_t> bytes, std::string_view name, const PngLimits& limits = {});

/// `name` is the file named in errors. Throws Error (badInput, overLimit), the latter before anything is allocated for pixels.
DecodedPng decodePng(std::span<const std::uint8_t> bytes, std::string_view name, const PngLimits& limits = {});

/// Reads a regular file (never a pipe or a device, which could hang or never end). Throws Error (badInput, overLimit).
Image loadPng(const std::filesystem::path& file, const PngLimits& limits = {});

} // namespace shadowlab::image
