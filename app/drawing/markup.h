// Text inside of SVG and HTML.
// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace shadowlab::drawing {

/// With the signs that markup is made of written as such. No control character is allowed there; each becomes a blank. What is no
/// character at all becomes the replacement character.
std::string escapedMarkup(std::string_view text);

/// Bytes as letters (RFC 4648, section 4), for data URIs.
std::string base64(std::span<const std::uint8_t> bytes);

} // namespace shadowlab::drawing
