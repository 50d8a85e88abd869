// SPDX-License-Identifier: MIT
#include "app/cli/json/json_values.h"

#include <cmath>

namespace shadowlab::cli {

Json vectorJson(const dvec2& v) { return {v.x, v.y}; }
Json vectorJson(const dvec3& v) { return {v.x, v.y, v.z}; }
Json vectorJson(const dvec4& v) { return {v.x, v.y, v.z, v.w}; }
Json vectorJson(const std::optional<dvec3>& v) { return v ? vectorJson(*v) : Json(); }
Json numberJson(double value) { return std::isfinite(value) ? Json(value) : Json(); }
Json numberJson(const std::optional<double>& value) { return value ? numberJson(*value) : Json(); }
Json displacementJson(const std::optional<judge::Displacement>& displacement) {
    if (!displacement) return nullptr;
    return {{"mean", displacement->mean}, {"p95", displacement->p95}, {"max", displacement->max}};
}

std::string truthName(judge::TruthOf truth) { return truth == judge::TruthOf::area ? "area" : "centre"; }

Json textJson(const std::string& text) { return text.empty() ? Json() : Json(text); }

Json timesJson(const judge::FrameTimes& times) {
    Json ms;
    ms["frame"] = times.frameMs();
    ms["prepare"] = times.prepareMs();
    ms["passes"] = Json::object();
    for (const gl::PassTimer::Result& pass : times.passMs())
        ms["passes"][pass.name] = pass.elapsedMs;
    return ms;
}

Json countersJson(const std::vector<Counter>& counters) {
    Json entries = Json::object();
    for (const Counter& counter : counters) {
        entries[counter.id]["built"] = counter.built;
        if (counter.of > 0) entries[counter.id]["of"] = counter.of;
        if (!counter.unit.empty()) entries[counter.id]["unit"] = counter.unit;
    }
    return entries;
}

} // namespace shadowlab::cli
