// SPDX-License-Identifier: MIT
#include "app/window/panels/panels.h"

#include "app/window/panels/widgets.h"

namespace shadowlab::window {

namespace {

using picture::Layout;

constexpr float kSceneComboEm = 10; ///< width of the choice of scenes

void sceneCombo(WindowState& ui, const Theme& theme) {
    const std::string& now = ui.bench.document().sceneName;
    const std::string shown = std::filesystem::path(now).filename().string();
    ImGui::SetNextItemWidth(kSceneComboEm * theme.em);
    if (ImGui::BeginCombo("##scene", shown.c_str(), ImGuiComboFlags_HeightLargest)) {
        for (const std::string& name : ui.scenes)
            if (ImGui::Selectable(name.c_str(), name == now)) ui.requests.scene = name;
        ImGui::EndCombo();
    }
    hint("scene (Ctrl+PageDown, Ctrl+PageUp); or drop a .json or .obj file on the window");
}

/// A button of the bar: its label, whether it is on, its help, and what it does.
struct BarButton {
    const char* label;
    bool on;
    const char* help;
    void (*press)(WindowState&);
};

std::vector<BarButton> barButtons(const WindowState& ui) {
    const lab::Document& document = ui.bench.document();
    const picture::StageRef& stage = document.panes[static_cast<std::size_t>(document.active)].stage;
    static const picture::StageRef kError{"error"}, kOutside{"outside"};
    const bool playing = ui.bench.animation().playing;
    return {
        {"1", document.layout == Layout::single, "single: the active pane alone (V)",
         [](WindowState& d) { chooseLayout(d, Layout::single); }},
        {"1 2", document.layout == Layout::side, "two pictures side by side (V)",
         [](WindowState& d) { chooseLayout(d, Layout::side); }},
        {"1|2", document.layout == Layout::split, "one picture, split by a line to be dragged (V)",
         [](WindowState& d) { chooseLayout(d, Layout::split); }},
        {"2x2", document.layout == Layout::grid, "grid of four (V)",
         [](WindowState& d) { chooseLayout(d, Layout::grid); }},
        {"1-2", document.layout == Layout::diff, "where two techniques differ, and who is right (V)",
         [](WindowState& d) { chooseLayout(d, Layout::diff); }},
        {playing ? "Pause" : "Play", playing, "plays and pauses (Space)",
         [](WindowState& d) { d.bench.play(!d.bench.animation().playing); }},
        {"Error", stage == kError, "where the technique is wrong (E)", [](WindowState& d) { toggleStage(d, kError); }},
        {"Stages", ui.shown.strip, "all stages as small pictures (T)",
         [](WindowState& d) { d.shown.strip = !d.shown.strip; }},
        {"Step", isStepping(ui), "the algorithm step by step (PageDown, PageUp)", [](WindowState& d) { step(d, 1); }},
        {"Source", ui.shown.source, "formula, pseudocode and source of the step (Y)", toggleSource},
        {"Lens", ui.shown.magnifier, "magnifier (M)", [](WindowState& d) { d.shown.magnifier = !d.shown.magnifier; }},
        {"Outside", stage == kOutside, "the second camera, which looks on from outside (O)",
         [](WindowState& d) { toggleStage(d, kOutside); }},
        {"Settings", ui.shown.panel, "the panel beside the pictures (I)",
         [](WindowState& d) { d.shown.panel = !d.shown.panel; }},
        {"Keys", ui.shown.keys, "all keys (H)", [](WindowState& d) { d.shown.keys = !d.shown.keys; }},
    };
}

float buttonWidth(const BarButton& button) {
    return ImGui::CalcTextSize(button.label).x + 2 * ImGui::GetStyle().FramePadding.x;
}

} // namespace

float topBarHeight(const WindowState& ui, const Theme& theme, float width) {
    const ImGuiStyle& style = ImGui::GetStyle();
    float x = 2 * style.WindowPadding.x + kSceneComboEm * theme.em;
    int rows = 1;
    for (const BarButton& button : barButtons(ui)) {
        x += style.ItemSpacing.x + buttonWidth(button);
        if (x <= width) continue;
        ++rows;
        x = 2 * style.WindowPadding.x + buttonWidth(button);
    }
    return static_cast<float>(rows) * (ImGui::GetFrameHeight() + style.ItemSpacing.y) - style.ItemSpacing.y +
           style.WindowPadding.y;
}

void topBar(WindowState& ui, const Area& area, const Theme& theme) {
    const ImGuiStyle& style = ImGui::GetStyle();
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {style.WindowPadding.x, style.WindowPadding.y * 0.5f});
    beginIn("bar", area, ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse | ImGuiWindowFlags_NoNav);
    ImGui::PopStyleVar();
    sceneCombo(ui, theme);
    float x = 2 * style.WindowPadding.x + kSceneComboEm * theme.em;
    for (const BarButton& button : barButtons(ui)) {
        x += style.ItemSpacing.x + buttonWidth(button);
        if (x <= static_cast<float>(area.size.x))
            ImGui::SameLine();
        else
            x = 2 * style.WindowPadding.x + buttonWidth(button);
        if (toggleButton(button.label, button.on, button.help)) button.press(ui);
    }
    ImGui::End();
}

} // namespace shadowlab::window
