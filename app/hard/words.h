// Words and numbers of the tables about hard cases.
// SPDX-License-Identifier: MIT
#pragma once
#include <string>
#include <vector>

#include "app/hard/results.h"

namespace shadowlab::hard {

/// The shortest that reads back as the same number.
std::string numberText(double value);
/// With blanks between.
std::string joined(const std::vector<std::string>& words);
/// "caught", "not caught", or that the check has no careless version.
std::string caughtText(const Row& row);
/// Of the case and the check, as far as the latter has one.
std::string titleOf(const CaseResult& result, const Row& row);

} // namespace shadowlab::hard
