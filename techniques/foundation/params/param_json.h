// Parameters as one flat JSON object, {"resolution": 1024, "filter": "pcf", "cull": true}: what statistics, lessons and
// saved settings hold.
// SPDX-License-Identifier: MIT
#pragma once
#include <nlohmann/json.hpp>

#include "techniques/foundation/params/param.h"

namespace shadowlab::params {

/// The current values, in the list's order.
nlohmann::ordered_json toJson(const ParamList& list);

/// Sets what the object names and leaves the rest. Throws Error (usage) for an unknown name, a wrong type or a value
/// out of range, and then has changed nothing.
void setFromJson(ParamList& list, const nlohmann::ordered_json& object, std::string_view owner);

} // namespace shadowlab::params
