// Columns of text for people to read.
// SPDX-License-Identifier: MIT
#pragma once
#include <string>
#include <vector>

namespace shadowlab::cli {

using Rows = std::vector<std::vector<std::string>>;

/// One line a row, its columns of equal width. The first and the last column are text and stand left, those between are
/// numbers and stand right. Rows may be short of columns.
std::string aligned(const Rows& rows);

} // namespace shadowlab::cli
