// Tables as comma-separated values (RFC 4180), and what their fields are made of.
// SPDX-License-Identifier: MIT
#pragma once
#include <string>
#include <vector>

namespace shadowlab::report {

/// One line with its end; fields are quoted where they have to be.
std::string csvLine(const std::vector<std::string>& fields);

/// The shortest text that reads back as the same number.
std::string numberText(double value);

/// With blanks between.
std::string joined(const std::vector<std::string>& words);

} // namespace shadowlab::report
