// SPDX-License-Identifier: MIT
#include "techniques/foundation/params/in_words.h"

#include <algorithm>

namespace shadowlab::params {

namespace {

/// "maps" is "map", "patches" is "patch"; "m" and "px" stay.
std::string singular(const std::string& unit) {
    if (unit.size() < 3 || !unit.ends_with('s')) return unit;
    return unit.substr(0, unit.size() - (unit.ends_with("ches") ? 2 : 1));
}

} // namespace

std::string inWords(const std::string& value, const Param& param) {
    if (param.kind == Kind::boolean) return value == "true" ? "on" : "off";
    const auto choice = std::ranges::find(param.choices, value) - param.choices.begin();
    if (choice < std::ssize(param.choiceNames) && !param.choiceNames[static_cast<std::size_t>(choice)].empty())
        return param.choiceNames[static_cast<std::size_t>(choice)];
    if (param.unit.empty()) return value;
    return value + " " + (value == "1" ? singular(param.unit) : param.unit);
}

} // namespace shadowlab::params
