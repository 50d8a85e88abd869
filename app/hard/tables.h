// The result of the hard cases as text: JSON, CSV (RFC 4180), and the words of their tables.
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

/// "caught", "not caught", or that the check has no careless version.
std::string caughtText(const Row& row);
/// Of the case and the check, as far as the latter has one.
std::string titleOf(const CaseResult& result, const Row& row);

} // namespace shadowlab::hard
