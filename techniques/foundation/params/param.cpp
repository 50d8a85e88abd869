// SPDX-License-Identifier: MIT
#include "techniques/foundation/params/param.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "techniques/foundation/base/error.h"
#include "techniques/foundation/base/nearest_names.h"

namespace shadowlab::params {

namespace {

/// Shortest text that reads back as the same number; never depends on the locale.
std::string numberText(double value) {
    char buffer[32];
    const auto [end, error] = std::to_chars(buffer, buffer + sizeof buffer, value);
    return error == std::errc{} ? std::string(buffer, end) : std::string("0");
}

std::string textOf(const Param& param, double value) {
    switch (param.kind) {
    case Kind::boolean:
    case Kind::choice: return param.choices[static_cast<std::size_t>(value)];
    case Kind::integer:
    case Kind::real: return numberText(value);
    }
    return {};
}

} // namespace

Param boolean(std::string id, bool& field, std::string help) {
    Param param{.id = std::move(id),
                .help = std::move(help),
                .unit = "",
                .kind = Kind::boolean,
                .minimum = 0,
                .maximum = 1,
                .choices = {"false", "true"},
                .get = [&field] { return field ? 1.0 : 0.0; },
                .set = [&field](double value) { field = value != 0; }};
    param.initial = param.get();
    return param;
}

Param integer(std::string id, int& field, int minimum, int maximum, std::string unit, std::string help) {
    Param param{.id = std::move(id),
                .help = std::move(help),
                .unit = std::move(unit),
                .kind = Kind::integer,
                .minimum = static_cast<double>(minimum),
                .maximum = static_cast<double>(maximum),
                .choices = {},
                .get = [&field] { return static_cast<double>(field); },
                .set = [&field](double value) { field = static_cast<int>(value); }};
    param.initial = param.get();
    return param;
}

Param real(std::string id, double& field, double minimum, double maximum, std::string unit, std::string help) {
    Param param{.id = std::move(id),
                .help = std::move(help),
                .unit = std::move(unit),
                .kind = Kind::real,
                .minimum = minimum,
                .maximum = maximum,
                .choices = {},
                .get = [&field] { return field; },
                .set = [&field](double value) { field = value; }};
    param.initial = param.get();
    return param;
}

Param onlyIf(std::function<bool()> condition, Param param) {
    if (param.hasEffect)
        param.hasEffect = [first = std::move(condition), second = std::move(param.hasEffect)] {
            return first() && second();
        };
    else
        param.hasEffect = std::move(condition);
    return param;
}

std::string valueText(const Param& param) { return textOf(param, param.get()); }
std::string initialText(const Param& param) { return textOf(param, param.initial); }

std::string rangeText(const Param& param) {
    if (param.kind == Kind::integer || param.kind == Kind::real)
        return numberText(param.minimum) + ".." + numberText(param.maximum);
    std::string text;
    for (const std::string& choice : param.choices)
        text += (text.empty() ? "" : "|") + choice;
    return text;
}

void setFromText(Param& param, std::string_view text, std::string_view owner) {
    const auto refuse = [&](const std::string& why, const std::string& remedy) {
        throw Error(ExitStatus::usage, "parameter '" + std::string(owner) + "." + param.id + "': '" +
                                           std::string(text) + "' " + why + "; " + remedy);
    };
    if (param.kind == Kind::boolean || param.kind == Kind::choice) {
        const auto found = std::ranges::find(param.choices, text);
        if (found == param.choices.end()) refuse("is not one of its values", "use one of " + rangeText(param));
        param.set(static_cast<double>(found - param.choices.begin()));
        return;
    }
    double value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    const bool whole = param.kind == Kind::real || value == std::floor(value);
    if (error != std::errc{} || end != text.data() + text.size() || !std::isfinite(value) || !whole)
        refuse(param.kind == Kind::real ? "is not a number" : "is not a whole number",
               "use " + rangeText(param) + (param.unit.empty() ? "" : " " + param.unit));
    if (value < param.minimum || value > param.maximum)
        refuse("is out of range", "use " + rangeText(param) + (param.unit.empty() ? "" : " " + param.unit));
    param.set(value);
}

Param& find(ParamList& list, std::string_view id, std::string_view owner) {
    const auto found = std::ranges::find(list, id, &Param::id);
    if (found != list.end()) return *found;
    std::vector<std::string> known;
    for (const Param& param : list)
        known.push_back(param.id);
    throw Error(ExitStatus::usage, "'" + std::string(owner) + "' has no parameter '" + std::string(id) + "'; " +
                                       (known.empty() ? "it has none" : suggestion(id, known)));
}

} // namespace shadowlab::params
