// SPDX-License-Identifier: MIT
#include "app/window/panels/panels.h"

#include <algorithm>

#include "app/window/key_functions.h"
#include "app/window/panels/icons.h"
#include "app/window/panels/widgets.h"

namespace shadowlab::window {

namespace {

using picture::Layout;

constexpr float kSceneComboEm = 11, kNarrowSceneComboEm = 6; ///< width of the choice of scenes

/// One button of the line: what it shows, and what it does.
struct BarButton {
    const char* id;
    Icon icon;
    bool on, enabled;
    const char* help;
    void (*press)(WindowState&);
    int rank;         ///< where the line is too short, those of the highest rank are left out first; keys do the same
    bool gap = false; ///< some room before it: another group begins
};

void openSaveMenu(WindowState&) { ImGui::OpenPopup("save menu"); }

/// Pictures of the window are made without a user, whose changes there would be to undo.
std::vector<BarButton> barButtons(const WindowState& ui) {
    const Layout layout = ui.bench.document().layout;
    const bool playing = ui.bench.animation().playing;
    return {
        {"single", Icon::single, layout == Layout::single, true, "one picture: the active pane alone (V)",
         [](WindowState& d) { chooseLayout(d, Layout::single); }, 0, true},
        {"side", Icon::side, layout == Layout::side, true, "two pictures side by side (V)",
         [](WindowState& d) { chooseLayout(d, Layout::side); }, 0},
        {"split", Icon::split, layout == Layout::split, true, "one picture, split by a line to be dragged (V)",
         [](WindowState& d) { chooseLayout(d, Layout::split); }, 0},
        {"grid", Icon::grid, layout == Layout::grid, true, "four pictures (V)",
         [](WindowState& d) { chooseLayout(d, Layout::grid); }, 1},
        {"difference", Icon::difference, layout == Layout::diff, true,
         "difference: where the two techniques differ, and which of them is right (V)",
         [](WindowState& d) { chooseLayout(d, Layout::diff); }, 0},
        {"play", playing ? Icon::pause : Icon::play, playing, true, playing ? "pauses (Space)" : "plays (Space)",
         [](WindowState& d) { d.bench.play(!d.bench.animation().playing); }, 0, true},
        {"undo", Icon::undo, false, ui.live && ui.bench.history().canUndo(), "takes the last change back (Ctrl+Z)",
         [](WindowState& d) { d.bench.undo(); }, 0},
        {"redo", Icon::redo, false, ui.live && ui.bench.history().canRedo(), "makes it again (Ctrl+Y)",
         [](WindowState& d) { d.bench.redo(); }, 2},
        {"stages", Icon::stages, ui.shown.strip, true, "all stages as small pictures (T)",
         [](WindowState& d) { d.shown.strip = !d.shown.strip; }, 1, true},
        {"lens", Icon::lens, ui.shown.magnifier, true, "magnifier (M)",
         [](WindowState& d) { d.shown.magnifier = !d.shown.magnifier; }, 3},
        {"save", Icon::save, false, true, "saves the picture, the scene, or a slide", openSaveMenu, 2, true},
        {"present", Icon::present, ui.shown.presenter, true, "presenter mode: large type, high contrast (D)",
         togglePresenter, 1},
        {"help", Icon::help, ui.shown.keys, true, "all keys (H)",
         turnKeyPage, 0},
        {"panel", Icon::panel, ui.shown.panel || ui.shown.source, true, "the panel beside the pictures (I)", togglePanel, 0},
    };
}

float buttonsWidth(const std::vector<BarButton>& buttons, float between) {
    float width = 0;
    for (const BarButton& button : buttons)
        width += ImGui::GetFrameHeight() * 1.15f + between * (button.gap ? 3 : 1);
    return width;
}

void sceneCombo(WindowState& ui, float width) {
    const std::string& now = ui.bench.document().sceneName;
    const std::string shown = std::filesystem::path(now).filename().string();
    ImGui::SetNextItemWidth(width);
    if (ImGui::BeginCombo("##scene", shown.c_str(), ImGuiComboFlags_HeightLargest)) {
        for (const std::string& name : ui.scenes)
            if (ImGui::Selectable(name.c_str(), name == now)) ui.requests.scene = name;
        const std::vector<scene::Viewpoint>& views = ui.bench.document().scene->viewpoints;
        if (!views.empty()) {
            ImGui::Separator();
            ImGui::TextDisabled("views of this scene");
        }
        for (std::size_t i = 0; i < views.size(); ++i) { // a view may be called as a scene is
            ImGui::PushID(static_cast<int>(i));
            if (ImGui::Selectable(views[i].name.c_str(), views[i].camera == ui.bench.document().camera)) ui.bench.setCamera(views[i].camera);
            ImGui::PopID();
        }
        ImGui::EndCombo();
    }
    hint("scene (Ctrl+PageDown, Ctrl+PageUp); or drop a .json, .obj, .gltf or .glb file on the window");
}

void saveMenu(WindowState& ui) {
    if (!ImGui::BeginPopup("save menu")) return;
    if (ImGui::MenuItem("The picture, its command line, and its scene", "P")) ui.requests.screenshot = true;
    if (ImGui::MenuItem("What is seen, as a scene", "Ctrl+S")) ui.requests.saveScene = true;
    if (ImGui::MenuItem("What is seen, as a slide", "W")) ui.requests.saveSlide = true;
    ImGui::EndPopup();
}

} // namespace

float topBarHeight() { return std::round(ImGui::GetFrameHeight() + ImGui::GetStyle().WindowPadding.y); }

void topBar(WindowState& ui, const Area& area, const Theme& theme) {
    const ImGuiStyle& style = ImGui::GetStyle();
    const float between = std::max(2.0f, style.ItemSpacing.x * 0.5f);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {style.WindowPadding.x, style.WindowPadding.y * 0.5f});
    beginIn("bar", area, ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse | ImGuiWindowFlags_NoNav);
    ImGui::PopStyleVar();
    std::vector<BarButton> buttons = barButtons(ui);
    const float room = static_cast<float>(area.size.x) - 2 * style.WindowPadding.x;
    for (int rank = 3; rank > 0 && buttonsWidth(buttons, between) + kNarrowSceneComboEm * theme.em > room; --rank)
        std::erase_if(buttons, [&](const BarButton& button) { return button.rank == rank; });
    sceneCombo(ui, std::clamp(room - buttonsWidth(buttons, between), theme.em, kSceneComboEm * theme.em));
    for (const BarButton& button : buttons) {
        ImGui::SameLine(0, between * (button.gap ? 3 : 1));
        ImGui::BeginDisabled(!button.enabled);
        if (iconButton(button.id, button.icon, button.on, button.help)) button.press(ui);
        ImGui::EndDisabled();
    }
    saveMenu(ui);
    ImGui::End();
}

} // namespace shadowlab::window
