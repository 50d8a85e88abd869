// Tables as comma-separated values (RFC 4180).
// SPDX-License-Identifier: MIT
#pragma once
#include <string>
#include <vector>

namespace shadowlab::report {

/// One line with its end; fields are quoted where they have to be.
std::string csvLine(const std::vector<std::string>& fields);

} // namespace shadowlab::report
