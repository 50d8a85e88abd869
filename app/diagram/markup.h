// Text inside of SVG and HTML.
// SPDX-License-Identifier: MIT
#pragma once
#include <string>
#include <string_view>

namespace shadowlab::diagram {

/// With the signs that markup is made of written as such. No control character is allowed there; each becomes a blank.
std::string escapedMarkup(std::string_view text);

} // namespace shadowlab::diagram
