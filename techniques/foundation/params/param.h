// A parameter, described once: the ImGui panel, --set, JSON, `list parameters` and the table in the docs all read the same
// list.
//
//     struct Params { int resolution = 1024; Filter filter = Filter::pcf; double offset = 1; };
//     ParamList list() {
//         return {
//             integer("resolution", params_.resolution, 64, 8192, "texels", "Side of the map."),
//             choice("filter", params_.filter, {"hard", {"pcf", "percentage-closer filtering"}}, "How texels are averaged."),
//             inGroup("Bias", real({"offset", "Depth offset"}, params_.offset, 0, 16, "texels", "Taken off the depth.")),
//         };
//     }
//
// A parameter in no group is *basic*: the panel always shows it. Those of a group are folded away below a heading. A class can take in
// about five settings at once, so a technique of the project has at most five basic ones that have an effect at the same time.
//
// A description refers to the field, so the list lives as long as the object that owns the fields.
// SPDX-License-Identifier: MIT
#pragma once
#include <functional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

namespace shadowlab::params {

enum class Kind { boolean, integer, real, choice };

/// The id of a parameter or of a choice, for --set and JSON, and in the field's words what it is, where the id does not say enough.
struct Named {
    std::string id;   ///< kebab-case, stable
    std::string name; ///< "": the id says it
    // Not explicit: a list of choices is written {"hard", {"pcf", "percentage-closer filtering"}}.
    Named(const char* id) : id(id) {}            // NOLINT(google-explicit-constructor)
    Named(std::string id) : id(std::move(id)) {} // NOLINT(google-explicit-constructor)
    Named(std::string_view id, std::string_view name) : id(id), name(name) {}
};

struct Param {
    std::string id;   ///< kebab-case, stable
    std::string help; ///< one line
    std::string unit; ///< "" where there is none
    Kind kind = Kind::boolean;
    double minimum = 0, maximum = 0;  ///< integer and real
    std::vector<std::string> choices; ///< choice; for booleans "false", "true"
    std::function<double()> get;      ///< booleans as 0 or 1, choices as their index
    std::function<void(double)> set;  ///< takes only values that are in range
    double initial = 0;               ///< the field's value when it was described
    /// False while the other parameters make it irrelevant; the panel then hides it. Empty: always true.
    std::function<bool()> hasEffect{};
    std::string label{}; ///< "Kernel radius"; labelOf() is what is shown
    std::string group{}; ///< heading of its fold; "": it is basic
    /// What each choice is, in words, in the order of `choices`; "": its id says it. Empty: so do all.
    std::vector<std::string> choiceNames{};
};
using ParamList = std::vector<Param>;

Param boolean(Named id, bool& field, std::string help);
Param integer(Named id, int& field, int minimum, int maximum, std::string unit, std::string help);
Param real(Named id, double& field, double minimum, double maximum, std::string unit, std::string help);

/// A choice by its number, counted from 0 in the order of `choices`: for fields that are no enumerations.
Param numberedChoice(Named id, std::function<int()> get, std::function<void(int)> set,
                     const std::vector<Named>& choices, std::string help);

/// `Enum` counts from 0 in the order of `choices`.
template <typename Enum>
requires std::is_enum_v<Enum> Param choice(Named id, Enum& field, const std::vector<Named>& choices, std::string help) {
    return numberedChoice(
        std::move(id), [&field] { return static_cast<int>(field); },
        [&field](int index) { field = static_cast<Enum>(index); }, choices, std::move(help));
}

/// The same parameter, which has an effect only while `condition` holds, beside the conditions it had before.
Param onlyIf(std::function<bool()> condition, Param param);
inline bool hasEffect(const Param& param) { return !param.hasEffect || param.hasEffect(); }

/// "Kernel radius"; of a parameter without a label, its id: "light-samples" -> "Light samples".
std::string labelOf(const Param& param);

/// Names of groups that many techniques have. They stand below all others in the panel, in this order.
inline constexpr std::string_view kTeachingSwitches =
    "Teaching switches";                              ///< each brings back a fault that the lecture is about
inline constexpr std::string_view kExpert = "Expert"; ///< seldom needed, or without effect on the picture

/// The same, in the group of that name.
Param inGroup(std::string_view group, Param param);
ParamList inGroup(std::string_view group, ParamList list);
inline bool isBasic(const Param& param) { return param.group.empty(); }

/// The parameters with one heading.
struct ParamGroup {
    std::string name; ///< "": the basic ones
    std::vector<const Param*> params;
};
/// First the basic ones; then the groups in the order in which they occur first, the teaching switches and the expert's last. The
/// pointers are into `list`.
std::vector<ParamGroup> grouped(const ParamList& list);

/// The current value, or `initial`, as --set and JSON write it: "true", "1024", "1.5", "pcf".
std::string valueText(const Param& param);
std::string initialText(const Param& param);
inline bool isChanged(const Param& param) { return valueText(param) != initialText(param); }

/// "false|true", "64..8192", "hard|pcf".
std::string rangeText(const Param& param);
/// "pcf: percentage-closer filtering; vsm: variance shadow map", of the choices whose names say more than their ids; "": none do.
std::string choicesText(const Param& param);

/// Sets from text. Throws Error (usage): out of range or not a value, naming the range. Never clamps.
void setFromText(Param& param, std::string_view text, std::string_view owner);

/// The parameter of that id. Throws Error (usage) naming the nearest ids, or all of them.
Param& find(ParamList& list, std::string_view id, std::string_view owner);

} // namespace shadowlab::params
