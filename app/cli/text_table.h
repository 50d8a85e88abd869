// Columns of text for people to read.
// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <string>
#include <vector>

namespace shadowlab::cli {

using Rows = std::vector<std::vector<std::string>>;

/// One line a row, its columns of equal width. The first and the last column are text and stand left, those between are
/// numbers and stand right. Rows may be short of columns.
std::string aligned(const Rows& rows);

/// The text in lines of at most so many characters, broken at blanks, and a longer word after | / and commas; what is longer even so
/// has a line of its own. No line for no words.
std::vector<std::string> wrapped(const std::string& text, std::size_t columns);

/// A list for a terminal of that many columns: headings, and below them rows of text, whose long columns are broken into several
/// lines. Where the terminal is too narrow for that, every row is a paragraph: its first column, and below it the others by name.
std::string listed(const std::vector<std::string>& headings, const Rows& rows, std::size_t columns);

} // namespace shadowlab::cli
