// A picture that another program has made, with what it says about itself.
// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>

#include "techniques/foundation/image/image.h"

namespace shadowlab::foreign {

/// Any PNG: grey or colours, with a palette or without, with alpha or without, of 1 to 16 bits; kept are 8 bits a channel.
image::Image loadForeign(const std::filesystem::path& file);

/// Is red = green = blue in all that is not transparent, but for two levels of rounding and chroma?
bool isGrey(const image::Image& picture);
/// Is any pixel not wholly opaque?
bool hasTransparency(const image::Image& picture);

/// Throws Error (badInput), naming both files, where the sizes differ.
void requireSameSize(const image::Image& picture, const std::filesystem::path& file, ivec2 size, const std::string& asWhat);

} // namespace shadowlab::foreign
