// The machine that a report was measured on. Needs a current GL context.
// SPDX-License-Identifier: MIT
#pragma once
#include "app/report/results.h"

namespace shadowlab::report {

Machine thisMachine(const std::string& backend);

} // namespace shadowlab::report
