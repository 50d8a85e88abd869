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

Param boolean(Named id, bool& field, std::string help) {
    Param param{.id = std::move(id.id),
                .help = std::move(help),
                .unit = "",
                .kind = Kind::boolean,
                .minimum = 0,
                .maximum = 1,
                .choices = {"false", "true"},
                .get = [&field] { return field ? 1.0 : 0.0; },
                .set = [&field](double value) { field = value != 0; },
                .label = std::move(id.name)};
    param.initial = param.get();
    return param;
}

Param integer(Named id, int& field, int minimum, int maximum, std::string unit, std::string help) {
    Param param{.id = std::move(id.id),
                .help = std::move(help),
                .unit = std::move(unit),
                .kind = Kind::integer,
                .minimum = static_cast<double>(minimum),
                .maximum = static_cast<double>(maximum),
                .choices = {},
                .get = [&field] { return static_cast<double>(field); },
                .set = [&field](double value) { field = static_cast<int>(value); },
                .label = std::move(id.name)};
    param.initial = param.get();
    return param;
}

Param real(Named id, double& field, double minimum, double maximum, std::string unit, std::string help) {
    Param param{.id = std::move(id.id),
                .help = std::move(help),
                .unit = std::move(unit),
                .kind = Kind::real,
                .minimum = minimum,
                .maximum = maximum,
                .choices = {},
                .get = [&field] { return field; },
                .set = [&field](double value) { field = value; },
                .label = std::move(id.name)};
    param.initial = param.get();
    return param;
}

Param numberedChoice(Named id, std::function<int()> get, std::function<void(int)> set,
                     const std::vector<Named>& choices, std::string help) {
    Param param{.id = std::move(id.id),
                .help = std::move(help),
                .unit = "",
                .kind = Kind::choice,
                .minimum = 0,
                .maximum = static_cast<double>(choices.size()) - 1,
                .choices = {},
                .get = [get = std::move(get)] { return static_cast<double>(get()); },
                .set = [set = std::move(set)](double value) { set(static_cast<int>(value)); },
                .label = std::move(id.name)};
    for (const Named& choice : choices) {
        param.choices.push_back(choice.id);
        param.choiceNames.push_back(choice.name);
    }
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

std::string labelOf(const Param& param) {
    if (!param.label.empty() || param.id.empty()) return param.label;
    std::string label = param.id;
    std::ranges::replace(label, '-', ' ');
    if (label.front() >= 'a' && label.front() <= 'z') label.front() = static_cast<char>(label.front() - 'a' + 'A');
    return label;
}

Param inGroup(std::string_view group, Param param) {
    param.group = group;
    return param;
}

ParamList inGroup(std::string_view group, ParamList list) {
    for (Param& param : list)
        param.group = group;
    return list;
}

std::vector<ParamGroup> grouped(const ParamList& list) {
    std::vector<ParamGroup> groups(1); // the basic ones
    for (const Param& param : list) {
        const auto known = std::ranges::find(groups, param.group, &ParamGroup::name);
        if (known == groups.end())
            groups.push_back({param.group, {&param}});
        else
            known->params.push_back(&param);
    }
    const auto rank = [](const ParamGroup& group) {
        return group.name == kExpert ? 2 : group.name == kTeachingSwitches ? 1 : 0;
    };
    std::ranges::stable_sort(groups, {}, rank);
    if (groups.front().params.empty()) groups.erase(groups.begin());
    return groups;
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

std::string choicesText(const Param& param) {
    std::string text;
    for (std::size_t i = 0; i < param.choiceNames.size(); ++i)
        if (!param.choiceNames[i].empty())
            text += (text.empty() ? "" : "; ") + param.choices[i] + ": " + param.choiceNames[i];
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
