// A report as one page for a browser that needs nothing else: charts, tables and pictures are in it, and it needs no network.
// SPDX-License-Identifier: MIT
#pragma once
#include <string>

#include "app/report/results.h"

namespace shadowlab::report {

/// The whole HTML file. The same report gives the same bytes.
std::string htmlPage(const Report& report);

} // namespace shadowlab::report
