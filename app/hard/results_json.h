// The result of a hard case as JSON, and back: the parts of an interrupted run, and hard.json, which is made of them.
// SPDX-License-Identifier: MIT
#pragma once
#include <nlohmann/json.hpp>

#include "app/hard/results.h"

namespace shadowlab::hard {

using Json = nlohmann::ordered_json;

Json toJson(const CaseResult& result);

/// Throws Json::exception where something is missing or of another kind. Pictures come back as names.
CaseResult caseResultFromJson(const Json& json);

} // namespace shadowlab::hard
