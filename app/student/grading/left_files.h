// What a plug-in's process has left of files, read without trust: it may have put anything in the place of a picture.
// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <vector>

#include "techniques/foundation/image/image.h"

namespace shadowlab::student {

/// The bytes of a regular file of at most 4 MiB; nothing where it is another thing, as a link, a pipe or a folder, or cannot be read.
std::optional<std::vector<std::uint8_t>> bytesLeftIn(const std::filesystem::path& file);

/// A PNG of any size; nothing where the bytes are none.
std::optional<image::Image> pictureIn(std::span<const std::uint8_t> bytes);
/// The same of that size, in pixels; nothing where it has another one.
std::optional<image::Image> pictureIn(std::span<const std::uint8_t> bytes, ivec2 size);

} // namespace shadowlab::student
