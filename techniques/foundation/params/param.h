// A parameter, described once: the ImGui panel, --set, JSON, `list parameters` and the table in the docs all read the same
// list.
//
//     struct Params { int resolution = 1024; Filter filter = Filter::pcf; };
//     ParamList list() { return { integer("resolution", params_.resolution, 64, 8192, "texels", "Side of the map."),
//     ... }; }
//
// A description refers to the field, so the list lives as long as the object that owns the fields.
// SPDX-License-Identifier: MIT
#pragma once
#include <functional>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace shadowlab::params {

enum class Kind { boolean, integer, real, choice };

struct Param {
    std::string id;   ///< kebab-case, stable
    std::string help; ///< one line
    std::string unit; ///< "" where there is none
    Kind kind = Kind::boolean;
    double minimum = 0, maximum = 0;   ///< integer and real
    std::vector<std::string> choices;  ///< choice; for booleans "false", "true"
    std::function<double()> get;       ///< booleans as 0 or 1, choices as their index
    std::function<void(double)> set;   ///< takes only values that are in range
    double initial = 0;                ///< the field's value when it was described
    std::function<bool()> hasEffect{}; ///< false while the other parameters make it irrelevant; the panel then hides it. Empty: always true
};
using ParamList = std::vector<Param>;

Param boolean(std::string id, bool& field, std::string help);
Param integer(std::string id, int& field, int minimum, int maximum, std::string unit, std::string help);
Param real(std::string id, double& field, double minimum, double maximum, std::string unit, std::string help);

/// `Enum` counts from 0 in the order of `choices`.
template <typename Enum>
requires std::is_enum_v<Enum> Param choice(std::string id, Enum& field, std::vector<std::string> choices,
                                           std::string help) {
    Param param;
    param.id = std::move(id);
    param.help = std::move(help);
    param.kind = Kind::choice;
    param.maximum = static_cast<double>(choices.size()) - 1;
    param.choices = std::move(choices);
    param.get = [&field] { return static_cast<double>(static_cast<int>(field)); };
    param.set = [&field](double index) { field = static_cast<Enum>(static_cast<int>(index)); };
    param.initial = param.get();
    return param;
}

/// The same parameter, which has an effect only while `condition` holds, beside the conditions it had before.
Param onlyIf(std::function<bool()> condition, Param param);
inline bool hasEffect(const Param& param) { return !param.hasEffect || param.hasEffect(); }

/// The current value, or `initial`, as --set and JSON write it: "true", "1024", "1.5", "pcf".
std::string valueText(const Param& param);
std::string initialText(const Param& param);

/// "false|true", "64..8192", "hard|pcf".
std::string rangeText(const Param& param);

/// Sets from text. Throws Error (usage): out of range or not a value, naming the range. Never clamps.
void setFromText(Param& param, std::string_view text, std::string_view owner);

/// The parameter of that id. Throws Error (usage) naming the nearest ids, or all of them.
Param& find(ParamList& list, std::string_view id, std::string_view owner);

} // namespace shadowlab::params
