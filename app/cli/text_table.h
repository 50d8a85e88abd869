// Columns of text for people to read.
// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace shadowlab::cli {

using Rows = std::vector<std::vector<std::string>>;

/// One line a row, its columns of equal width. The first and the last column are text and stand left, those between are
/// numbers and stand right. Rows may be short of columns.
std::string aligned(const Rows& rows);

/// The same for a terminal of that many columns; in a pipe (none) exactly the same. A table that is too wide goes on below itself with its
/// first column again, and a long text at the end of a row is broken into several lines.
std::string aligned(const Rows& rows, std::optional<std::size_t> columns);

/// The text in lines of at most so many characters, broken at blanks, and a longer word after | / and commas; what is longer even so
/// has a line of its own. No line for no words.
std::vector<std::string> wrapped(const std::string& text, std::size_t columns);

/// Lines for a terminal of that many columns; in a pipe (none) the same as they are. What is longer is broken at blanks and goes on below
/// its own last column, which two blanks set off, or two blanks further in.
std::string fitting(const std::string& text, std::optional<std::size_t> columns);

/// A list for a terminal of that many columns: headings, and below them rows of text, whose long columns are broken into several
/// lines. Where the terminal is too narrow for that, every row is a paragraph: its first column, and below it the others by name.
std::string listed(const std::vector<std::string>& headings, const Rows& rows, std::size_t columns);

} // namespace shadowlab::cli
