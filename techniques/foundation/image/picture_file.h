// The pictures that a material may name: PNG or JPEG, told apart by how the file starts and not by its name.
// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <span>
#include <string_view>

#include "techniques/foundation/image/png/png.h"

namespace shadowlab::image {

struct PictureFile {
    Image image;
    bool hasAlpha = false; ///< the file has an alpha channel; else alpha is 255 everywhere
};

/// The name of a format, common among textures, that is not read here: BMP, WebP, KTX2 and others; empty: none of these.
std::string_view otherFormat(std::string_view bytes);

/// Reads only the header. Throws Error (badInput, overLimit), as pictureFrom does.
PngSize pictureSize(std::span<const std::uint8_t> bytes, std::string_view name, const PngLimits& limits);

/// `name` is the file named in errors. A file that starts like neither is refused with the names of both.
PictureFile pictureFrom(std::span<const std::uint8_t> bytes, std::string_view name, const PngLimits& limits);

} // namespace shadowlab::image
