// SPDX-License-Identifier: MIT
#include "app/window/panels/panels.h"

#include <algorithm>
#include <optional>

#include "techniques/foundation/base/error.h"
#include "techniques/foundation/params/in_words.h"
#include "techniques/registry.h"

namespace shadowlab::window {

namespace {

/// Sliders over more than this range go by factors: doubling a map of 64 texels
/// takes as long a way as doubling one of 4096.
constexpr double kLogarithmicFrom = 100;

bool isWide(const params::Param& param) {
    return param.minimum > 0 && param.maximum / param.minimum >= kLogarithmicFrom;
}

std::string shownValue(const params::Param& param) { return params::inWords(params::valueText(param), param); }

void tooltip(const params::Param& param, const Theme& theme) {
    if (!ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled)) return;
    ImGui::BeginTooltip();
    ImGui::PushTextWrapPos(theme.em * 26);
    ImGui::TextUnformatted(param.help.c_str());
    const std::string range = param.id + ": " + params::rangeText(param) +
                              (param.unit.empty() ? "" : " " + param.unit) + ", default " + params::initialText(param);
    ImGui::TextDisabled("%s", range.c_str());
    if (param.kind == params::Kind::integer || param.kind == params::Kind::real)
        ImGui::TextDisabled("Ctrl+click: type a value");
    ImGui::PopTextWrapPos();
    ImGui::EndTooltip();
}

/// A slider without its value in it, which the grab would hide. While a value is typed into it (Ctrl+click), that is shown.
bool slider(const params::Param& param, double& value) {
    const ImGuiSliderFlags flags =
        ImGuiSliderFlags_AlwaysClamp | (isWide(param) ? ImGuiSliderFlags_Logarithmic : ImGuiSliderFlags_None);
    const ImVec2 from = ImGui::GetCursorScreenPos();
    const ImVec2 to{from.x + ImGui::CalcItemWidth(), from.y + ImGui::GetFrameHeight()};
    ImGuiStorage& storage = *ImGui::GetStateStorage();
    const ImGuiID typing = ImGui::GetID("typing");
    const bool beginsToType = ImGui::GetIO().KeyCtrl && ImGui::IsMouseHoveringRect(from, to);
    const bool hidden = !storage.GetBool(typing) && !beginsToType;
    if (hidden) ImGui::PushStyleColor(ImGuiCol_Text, IM_COL32(0, 0, 0, 0));
    bool changed = false;
    if (param.kind == params::Kind::integer) {
        int whole = static_cast<int>(value);
        changed = ImGui::SliderInt("##value", &whole, static_cast<int>(param.minimum), static_cast<int>(param.maximum),
                                   "%d", flags);
        if (changed) value = whole;
    } else {
        changed =
            ImGui::SliderScalar("##value", ImGuiDataType_Double, &value, &param.minimum, &param.maximum, "%.4g", flags);
    }
    if (hidden) ImGui::PopStyleColor();
    storage.SetBool(typing, ImGui::IsItemActive() && ImGui::GetIO().WantTextInput);
    return changed;
}

/// The widget of one parameter; its new value, when it was changed.
std::optional<double> widget(const params::Param& param) {
    double value = param.get();
    switch (param.kind) {
    case params::Kind::boolean: {
        bool on = value != 0;
        if (ImGui::Checkbox("##value", &on)) return on ? 1.0 : 0.0;
        return {};
    }
    case params::Kind::choice: {
        ImGui::SetNextItemWidth(-FLT_MIN);
        if (!ImGui::BeginCombo("##value", shownValue(param).c_str(), ImGuiComboFlags_HeightLargest)) return {};
        std::optional<double> chosen;
        for (std::size_t i = 0; i < param.choices.size(); ++i) {
            const std::string& id = param.choices[i];
            const std::string name = i < param.choiceNames.size() ? param.choiceNames[i] : "";
            ImGui::PushID(id.c_str());
            if (ImGui::Selectable((name.empty() ? id : name).c_str(), static_cast<double>(i) == value))
                chosen = static_cast<double>(i);
            if (!name.empty()) { // what --set and scene files call it
                ImGui::SameLine();
                ImGui::TextDisabled("%s", id.c_str());
            }
            ImGui::PopID();
        }
        ImGui::EndCombo();
        return chosen;
    }
    case params::Kind::integer:
    case params::Kind::real:
        ImGui::SetNextItemWidth(-FLT_MIN);
        if (slider(param, value)) return value;
        return {};
    }
    return {};
}

/// The label of a parameter and at the right end of the same line its value, where no slider covers it. True when the button behind
/// them, which takes a change back, was pressed.
bool headLine(const params::Param& param, const Theme& theme) {
    const float right = ImGui::GetContentRegionMax().x, button = ImGui::GetFontSize() * 1.4f;
    const bool isNumber = param.kind == params::Kind::integer || param.kind == params::Kind::real;
    const std::string value = isNumber ? shownValue(param) : "";
    const float room = button + ImGui::GetStyle().ItemSpacing.x;
    const float valueAt = right - room - ImGui::CalcTextSize(value.c_str()).x;
    ImGui::PushTextWrapPos(valueAt - ImGui::GetStyle().ItemSpacing.x);
    ImGui::TextUnformatted(params::labelOf(param).c_str());
    ImGui::PopTextWrapPos();
    tooltip(param, theme);
    if (isNumber) {
        ImGui::SameLine(valueAt);
        ImGui::TextUnformatted(value.c_str());
        tooltip(param, theme);
    }
    if (!params::isChanged(param)) return false;
    ImGui::SameLine(right - button);
    const bool pressed = ImGui::SmallButton("\xC2\xAB");
    if (ImGui::IsItemHovered()) ImGui::SetTooltip("back to %s", params::initialText(param).c_str());
    return pressed;
}

/// What the user made of a parameter: its new value as text, and the gesture that it belongs to.
struct Change {
    std::string text, gesture;
};

std::optional<Change> parameterRow(WindowState& ui, const params::Param& param, const Theme& theme) {
    std::optional<Change> change;
    ImGui::PushID(param.id.c_str());
    std::optional<double> value;
    const auto show = [&] {
        value = widget(param);
        const bool released = ImGui::IsItemDeactivated();
        tooltip(param, theme);
        if (released) ui.bench.endGesture();
    };
    const bool inOneLine = param.kind == params::Kind::boolean;
    if (inOneLine) {
        show();
        ImGui::SameLine();
        ImGui::AlignTextToFramePadding();
    } else { // the label is nearer to its own widget than to the one above
        ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {ImGui::GetStyle().ItemSpacing.x, 1});
    }
    if (headLine(param, theme)) change = Change{params::initialText(param), ""};
    if (!inOneLine) {
        ImGui::PopStyleVar();
        show();
    }
    if (value) {
        const double before = param.get();
        param.set(*value);
        change = Change{params::valueText(param), "set " + param.id};
        param.set(before); // the slot takes it from the document, as from everywhere else
    }
    ImGui::PopID();
    return change;
}

/// Parameters without an effect, as the others are set, are hidden unless they differ from their defaults.
bool isShown(const params::Param& param) { return params::hasEffect(param) || params::isChanged(param); }

/// The heading of a group. It is folded at first, says how many of its values differ from the defaults, and opens when there are more of
/// them than before: a lesson or a scene has changed something in it. True while it is open.
bool groupHeading(const params::ParamGroup& group) {
    const auto changed = static_cast<int>(
        std::ranges::count_if(group.params, [](const auto* param) { return params::isChanged(*param); }));
    ImGuiStorage& storage = *ImGui::GetStateStorage();
    const ImGuiID before = ImGui::GetID((group.name + " changed").c_str());
    if (changed > storage.GetInt(before)) ImGui::SetNextItemOpen(true);
    storage.SetInt(before, changed);
    const std::string count = changed ? "  (" + std::to_string(changed) + " changed)" : "";
    return ImGui::TreeNodeEx((group.name + count + "###" + group.name).c_str(),
                             ImGuiTreeNodeFlags_SpanAvailWidth | ImGuiTreeNodeFlags_NoTreePushOnOpen);
}

} // namespace

void parameterPanel(WindowState& ui, const Theme& theme) {
    const lab::PaneState state = ui.bench.activeState();
    picture::Slot* found = nullptr;
    try {
        found = &ui.bench.pane(ui.bench.document().active).slotFor(state);
    } catch (const Error&) {
        // The pane says what is wrong with a value; here is the way out.
        if (ImGui::Button("All as by default  (R)")) resetSettings(ui);
        return;
    }
    picture::Slot& slot = *found;
    if (slot.params.empty()) ImGui::TextDisabled("This technique has nothing to set.");
    ImGui::PushID(state.technique.c_str());
    for (const params::ParamGroup& group : params::grouped(slot.params)) {
        if (std::ranges::none_of(group.params, [](const auto* param) { return isShown(*param); })) continue;
        if (!group.name.empty() && !groupHeading(group)) continue;
        for (const params::Param* param : group.params) {
            if (!isShown(*param)) continue;
            const std::optional<Change> change = parameterRow(ui, *param, theme);
            if (!change) continue;
            ui.bench.change(change->gesture, [&](lab::Document& changed) {
                lab::Values& values = changed.panes[static_cast<std::size_t>(changed.active)].settings[state.technique];
                if (change->text == params::initialText(*param))
                    values.erase(param->id);
                else
                    values[param->id] = change->text;
            });
        }
    }
    ImGui::PopID();
    if (!state.values().empty() && ImGui::Button("All as by default  (R)")) resetSettings(ui);
}

} // namespace shadowlab::window
