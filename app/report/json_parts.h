// Plans, errors and times as JSON, and back.
// SPDX-License-Identifier: MIT
#pragma once
#include <nlohmann/json.hpp>

#include "app/report/frame_timer.h"
#include "app/report/plan.h"
#include "app/report/results.h"

namespace shadowlab::report {

using Json = nlohmann::ordered_json;

Json toJson(const PointKey& point);
Json toJson(const Plan& plan);
Json toJson(const Errors& errors);
Json toJson(const Times& times);
Json toJson(const Machine& machine);

// These throw Json::exception where something is missing or of another kind, and std::domain_error where a number cannot be: less
// than no pixel, or more wrong pixels than there are.
PointKey pointFromJson(const Json& json);
Plan planFromJson(const Json& json);
Errors errorsFromJson(const Json& json);
Times timesFromJson(const Json& json);
Machine machineFromJson(const Json& json);

} // namespace shadowlab::report
