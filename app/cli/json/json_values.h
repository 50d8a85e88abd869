// The values that the JSON of all commands is made of.
// SPDX-License-Identifier: MIT
#pragma once
#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "app/judge/metrics/boundary.h"
#include "app/judge/metrics/frame_times.h"
#include "app/judge/truth.h"
#include "techniques/foundation/math/types.h"
#include "techniques/frame.h"

namespace shadowlab::cli {

using Json = nlohmann::ordered_json; // keys stay in the order in which they are written

/// A list of the components.
Json vectorJson(const dvec2& v);
Json vectorJson(const dvec3& v);
Json vectorJson(const dvec4& v);
Json vectorJson(const std::optional<dvec3>& v); ///< null where there is none
/// null where the number is infinite or none at all: JSON has no such number.
Json numberJson(double value);
Json numberJson(const std::optional<double>& value);
/// {"frame", "prepare", "passes": {...}}, medians in milliseconds.
Json timesJson(const judge::FrameTimes& times);
/// {"casters": {"built", "of", "unit"}, ...}
Json countersJson(const std::vector<Counter>& counters);
/// {"mean", "p95", "max"} in pixels; null where there is none.
Json displacementJson(const std::optional<judge::Displacement>& displacement);
/// "area" or "centre": what of a light the truth is about.
std::string truthName(judge::TruthOf truth);
/// null where the text is empty.
Json textJson(const std::string& text);

} // namespace shadowlab::cli
