// Pictures as WebP, for pages that hold many of them. The same picture gives the same bytes with one version of libwebp.
// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <vector>

#include "techniques/foundation/image/image.h"

namespace shadowlab::image {

enum class WebpKind {
    exact,   ///< without loss, alpha included
    photo,   ///< with loss that is hard to see; alpha without loss
    letters, ///< the same with less loss, for pictures in which something is written
};

/// Throws Error (overLimit) for a picture of more than 16383 pixels on a side, the format's limit, and (bug) should libwebp fail.
std::vector<std::uint8_t> encodeWebp(const Image& image, WebpKind kind);

} // namespace shadowlab::image
