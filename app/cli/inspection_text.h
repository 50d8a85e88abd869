// What `inspect` found out, as a reader wants it: tables, and what is odd.
// SPDX-License-Identifier: MIT
#pragma once
#include <string>

#include "app/cli/inspection.h"

namespace shadowlab::cli {

std::string inspectionText(const Inspection& inspection);

} // namespace shadowlab::cli
