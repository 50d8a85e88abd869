// The checks of hard cases as JSON, as CSV (RFC 4180), and as a page for a browser that needs nothing else.
// SPDX-License-Identifier: MIT
#pragma once
#include <string>
#include <vector>

#include "app/hard/run_case.h"

namespace shadowlab::hard {

/// One case and what came of it; of a case about numbers alone there are no rows.
struct CaseResult {
    std::string id, title, why;
    std::vector<Row> rows;
    std::vector<std::string> tests; ///< that hold it, too
};

std::string hardJson(const std::vector<CaseResult>& results, const std::string& renderer);
std::string hardCsv(const std::vector<CaseResult>& results);
std::string hardPage(const std::vector<CaseResult>& results, const std::string& renderer);

} // namespace shadowlab::hard
