// What `inspect` found out, for programs.
// SPDX-License-Identifier: MIT
#pragma once
#include "app/cli/inspection.h"
#include "app/cli/json/json_values.h"

namespace shadowlab::cli {

Json inspectionJson(const Inspection& inspection);

} // namespace shadowlab::cli
