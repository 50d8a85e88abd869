// What came of the hard cases as JSON and as CSV (RFC 4180).
// SPDX-License-Identifier: MIT
#pragma once
#include <string>
#include <vector>

#include "app/hard/results.h"

namespace shadowlab::hard {

std::string hardJson(const std::vector<CaseResult>& results, const std::string& renderer);

/// A line for each expectation of each check.
std::string hardCsv(const std::vector<CaseResult>& results);

/// A line for each technique before each case's scene.
std::string matrixCsv(const std::vector<CaseResult>& results);

} // namespace shadowlab::hard
