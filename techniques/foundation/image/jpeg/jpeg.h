// JPEG in, through libjpeg-turbo's TurboJPEG interface.
// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <span>
#include <string_view>

#include "techniques/foundation/image/png/png.h"

namespace shadowlab::image {

/// Do the bytes start like a JPEG file?
bool startsLikeJpeg(std::span<const std::uint8_t> bytes);

/// Reads only the header; allocates nothing for the pixels. Throws as decodeJpeg does.
PngSize jpegSize(std::span<const std::uint8_t> bytes, std::string_view name, const PngLimits& limits = {});

/// Grey, YCbCr or RGB, baseline or progressive. `name` is the file named in errors. Throws Error (badInput, overLimit), the
/// latter before anything is allocated for pixels. A file that ends too early is refused, as a PNG is.
Image decodeJpeg(std::span<const std::uint8_t> bytes, std::string_view name, const PngLimits& limits = {});

} // namespace shadowlab::image
