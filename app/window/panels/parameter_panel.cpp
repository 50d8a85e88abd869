// SPDX-License-Identifier: MIT
#include "app/window/panels/panels.h"

#include <cmath>

#include "techniques/foundation/base/error.h"
#include "techniques/registry.h"

namespace shadowlab::window {

namespace {

/// Sliders over more than this range go by factors: doubling a map of 64 texels
/// takes as long a way as doubling one of 4096.
constexpr double kLogarithmicFrom = 100;

bool isWide(const params::Param& param) {
    return param.minimum > 0 && param.maximum / param.minimum >= kLogarithmicFrom;
}

/// "shadow-map.bias" -> "bias", and dashes to spaces.
std::string labelOf(const params::Param& param) {
    std::string label = param.id;
    for (char& c : label)
        if (c == '-') c = ' ';
    return label;
}

void tooltip(const params::Param& param, const Theme& theme) {
    if (!ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled)) return;
    ImGui::BeginTooltip();
    ImGui::PushTextWrapPos(theme.em * 26);
    ImGui::TextUnformatted(param.help.c_str());
    const std::string range = params::rangeText(param) + (param.unit.empty() ? "" : " " + param.unit) + ", default " +
                              params::initialText(param);
    ImGui::TextDisabled("%s", range.c_str());
    ImGui::PopTextWrapPos();
    ImGui::EndTooltip();
}

/// The widget of one parameter; its new value, when it was changed.
std::optional<double> widget(const params::Param& param) {
    double value = param.get();
    ImGui::SetNextItemWidth(-FLT_MIN);
    const ImGuiSliderFlags flags =
        ImGuiSliderFlags_AlwaysClamp | (isWide(param) ? ImGuiSliderFlags_Logarithmic : ImGuiSliderFlags_None);
    switch (param.kind) {
    case params::Kind::boolean: {
        bool on = value != 0;
        if (ImGui::Checkbox("##value", &on)) return on ? 1.0 : 0.0;
        return {};
    }
    case params::Kind::choice: {
        if (!ImGui::BeginCombo("##value", params::valueText(param).c_str())) return {};
        std::optional<double> chosen;
        for (std::size_t i = 0; i < param.choices.size(); ++i)
            if (ImGui::Selectable(param.choices[i].c_str(), static_cast<double>(i) == value))
                chosen = static_cast<double>(i);
        ImGui::EndCombo();
        return chosen;
    }
    case params::Kind::integer: {
        int whole = static_cast<int>(value);
        if (ImGui::SliderInt("##value", &whole, static_cast<int>(param.minimum), static_cast<int>(param.maximum), "%d",
                             flags))
            return whole;
        return {};
    }
    case params::Kind::real: {
        if (ImGui::SliderScalar("##value", ImGuiDataType_Double, &value, &param.minimum, &param.maximum, "%.4g", flags))
            return value;
        return {};
    }
    }
    return {};
}

} // namespace

void parameterPanel(WindowState& ui, const Theme& theme) {
    const lab::Document& document = ui.bench.document();
    const lab::PaneState state = document.panes[static_cast<std::size_t>(document.active)];
    picture::Slot* found = nullptr;
    try {
        found = &ui.bench.pane(document.active).slotFor(state);
    } catch (const Error&) {
        // The pane says what is wrong with a value; here is the way out.
        if (ImGui::Button("All as by default  (R)")) resetSettings(ui);
        return;
    }
    picture::Slot& slot = *found;
    if (slot.params.empty()) ImGui::TextDisabled("This technique has nothing to set.");
    const float reset = ImGui::GetFrameHeight();
    if (!slot.params.empty() && ImGui::BeginTable("parameters", 3)) {
        ImGui::TableSetupColumn("name", ImGuiTableColumnFlags_WidthStretch, 0.46f);
        ImGui::TableSetupColumn("value", ImGuiTableColumnFlags_WidthStretch, 0.54f);
        ImGui::TableSetupColumn("reset", ImGuiTableColumnFlags_WidthFixed, reset);
        for (params::Param& param : slot.params) {
            // Parameters without an effect, as the others are set, are hidden unless they differ from their defaults.
            if (!params::hasEffect(param) && params::valueText(param) == params::initialText(param)) continue;
            ImGui::PushID(param.id.c_str());
            ImGui::TableNextRow();
            ImGui::TableNextColumn();
            ImGui::AlignTextToFramePadding();
            ImGui::TextWrapped("%s", labelOf(param).c_str());
            tooltip(param, theme);
            ImGui::TableNextColumn();
            const auto set = [&](const std::string& text, const std::string& gesture) {
                ui.bench.change(gesture, [&](lab::Document& changed) {
                    lab::Values& values =
                        changed.panes[static_cast<std::size_t>(changed.active)].settings[state.technique];
                    if (text == params::initialText(param))
                        values.erase(param.id);
                    else
                        values[param.id] = text;
                });
            };
            const std::optional<double> value = widget(param);
            tooltip(param, theme);
            if (value) {
                const double before = param.get();
                param.set(*value);
                const std::string text = params::valueText(param);
                param.set(before); // the slot takes it from the document, as from everywhere else
                set(text, "set " + param.id);
            }
            if (ImGui::IsItemDeactivated()) ui.bench.endGesture();
            ImGui::TableNextColumn();
            if (params::valueText(param) != params::initialText(param)) {
                if (ImGui::Button("\xC2\xAB", {reset, 0})) set(params::initialText(param), "");
                if (ImGui::IsItemHovered()) ImGui::SetTooltip("back to %s", params::initialText(param).c_str());
            }
            ImGui::PopID();
        }
        ImGui::EndTable();
    }
    if (!state.values().empty() && ImGui::Button("All as by default  (R)")) resetSettings(ui);
}

} // namespace shadowlab::window
