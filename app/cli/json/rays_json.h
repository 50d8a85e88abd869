// What probes know of spread rays, of structures and of equations, as JSON.
// SPDX-License-Identifier: MIT
#pragma once
#include "app/cli/json/json_values.h"
#include "techniques/probe.h"

namespace shadowlab::cli {

// Each is null where the technique has none.
Json samplesJson(const Probe& probe);
Json structureJson(const Probe& probe);
Json equationsJson(const Probe& probe);

} // namespace shadowlab::cli
