// Where a sentence with numbers may go on in the next line: at blanks, but not between a number and its unit, or within a sum.
// ImGui itself also breaks behind points and commas, and so within numbers.
// SPDX-License-Identifier: MIT
#pragma once
#include <functional>
#include <string>
#include <vector>

namespace shadowlab::window {

/// Width of a text, in pixels.
using TextWidth = std::function<float(const std::string&)>;

/// The text in lines that are no wider than `width`. What belongs together stays so, unless it is wider than a line by itself; a
/// word is never broken.
std::vector<std::string> brokenText(const std::string& text, float width, const TextWidth& widthOf);

} // namespace shadowlab::window
