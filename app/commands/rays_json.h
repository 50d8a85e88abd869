// What probes know of spread rays, of structures and of equations, as JSON.
// SPDX-License-Identifier: MIT
#pragma once
#include <nlohmann/json.hpp>

#include "techniques/probe.h"

namespace shadowlab::commands {

// Each is null where the technique has none.
nlohmann::ordered_json samplesJson(const Probe& probe);
nlohmann::ordered_json structureJson(const Probe& probe);
nlohmann::ordered_json equationsJson(const Probe& probe);

} // namespace shadowlab::commands
