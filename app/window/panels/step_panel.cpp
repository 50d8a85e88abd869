// SPDX-License-Identifier: MIT
#include "app/window/panels/panels.h"

#include <algorithm>
#include <cmath>

#include "app/picture/steps/stepping.h"
#include "app/window/panels/widgets.h"
#include "techniques/registry.h"

namespace shadowlab::window {

namespace {

constexpr float kStepNumberEm = 15; ///< room for the arrows and "Step 3 of 12  (light name)" before a step's title

} // namespace

bool isStepping(const WindowState& ui) {
    const lab::Document& document = ui.bench.document();
    return document.panes[static_cast<std::size_t>(document.active)].stage.isPass;
}

float stepPanelHeight(const WindowState& ui, const Theme& theme, float width) {
    if (!isStepping(ui)) return 0;
    const lab::Document& document = ui.bench.document();
    const TechniqueInfo& info = findTechnique(document.panes[static_cast<std::size_t>(document.active)].technique);
    const ImGuiStyle& style = ImGui::GetStyle();
    const float room = std::max(theme.em, width - 2 * style.WindowPadding.x);
    const float titleRoom = std::max(theme.em, room - kStepNumberEm * theme.em);
    const auto lines = [](ImFont* font, float size, float wrap, std::string_view text) {
        return text.empty() ? 0.0f : font->CalcTextSizeA(size, FLT_MAX, wrap, text.data(), text.data() + text.size()).y;
    };
    const auto plain = [&](std::string_view text) { return lines(theme.text, theme.em, room, text); };
    float highest = 0;
    for (const PassInfo& pass : info.passes)
        highest = std::max(
            highest, std::max(ImGui::GetFrameHeight(), lines(theme.heading, theme.headingSize, titleRoom, pass.title)) +
                         plain(pass.why) + (ui.shown.source ? 0 : plain(pseudocodeOf(info, pass))) +
                         plain("GL state: " + std::string(pass.glState)));
    return std::ceil(highest + 2 * style.WindowPadding.y + 4 * style.ItemSpacing.y);
}

void stepPanel(WindowState& ui, const Area& area, const Theme& theme) {
    const lab::Document& document = ui.bench.document();
    const lab::PaneState& state = document.panes[static_cast<std::size_t>(document.active)];
    const scene::Scene& scene = *ui.bench.shownScene();
    const std::vector<StageKey>& passes = ui.bench.pane(document.active).passesOf(state.technique, scene);
    const auto now = picture::stepOf(state.stage, passes, scene, document.light);
    beginIn("step", area, ImGuiWindowFlags_NoNav);
    if (!now) {
        // The list of steps is complete only after a frame was drawn; in a window without room for a picture none is.
        ImGui::TextWrapped(passes.empty() ? "Nothing has been drawn yet: the window has no room for a picture."
                                          : "This step does not run with these settings; PageDown goes to the first "
                                            "that does.");
        ImGui::End();
        return;
    }
    const PassInfo& pass = passInfo(findTechnique(state.technique).passes, passes[*now].id);
    if (ImGui::ArrowButton("back", ImGuiDir_Left)) step(ui, -1);
    hint("the step before (PageUp)");
    ImGui::SameLine();
    if (ImGui::ArrowButton("on", ImGuiDir_Right)) step(ui, 1);
    hint("the next step (PageDown)");
    ImGui::SameLine();
    ImGui::AlignTextToFramePadding();
    const int light = passes[*now].light;
    const std::string of =
        light == kNoLight || scene.lights.size() < 2 ? "" : "  (light " + scene.light(light).name + ")";
    ImGui::TextColored(ImGui::ColorConvertU32ToFloat4(kAccent), "Step %d of %d%s", static_cast<int>(*now) + 1,
                       static_cast<int>(passes.size()), of.c_str());
    ImGui::SameLine();
    ImGui::SetCursorPosX(std::max(ImGui::GetCursorPosX(), ImGui::GetStyle().WindowPadding.x));
    ImGui::PushFont(theme.heading);
    ImGui::TextWrapped("%s", std::string(pass.title).c_str());
    ImGui::PopFont();
    ImGui::TextWrapped("%s", std::string(pass.why).c_str());
    const std::string pseudocode = pseudocodeOf(findTechnique(state.technique), pass);
    if (!pseudocode.empty() && !ui.shown.source) { // beside the picture it is said already
        ImGui::PushStyleColor(ImGuiCol_Text, kAccent);
        ImGui::TextWrapped("%s", pseudocode.c_str());
        ImGui::PopStyleColor();
    }
    ImGui::PushStyleColor(ImGuiCol_Text, ImGui::GetStyle().Colors[ImGuiCol_TextDisabled]);
    ImGui::TextWrapped("GL state: %s", std::string(pass.glState).c_str());
    ImGui::PopStyleColor();
    ImGui::End();
}

} // namespace shadowlab::window
