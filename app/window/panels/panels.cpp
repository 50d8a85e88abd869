// SPDX-License-Identifier: MIT
#include "app/window/panels/panels.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "app/picture/derived_stages.h"
#include "app/picture/steps/stepping.h"
#include "app/window/panels/error_panel.h"
#include "app/window/panels/lesson_panel.h"
#include "app/window/panels/parameter_panel.h"
#include "app/window/panels/pixel_panel.h"
#include "app/window/panels/slide_panel.h"
#include "techniques/registry.h"

namespace shadowlab::window {

namespace {

using picture::Layout;

constexpr float kStepNumberEm = 15; ///< room for the arrows and "Step 3 of 12  (light name)" before a step's title
constexpr float kSceneComboEm = 10; ///< width of the choice of scenes

constexpr ImGuiWindowFlags kFixed = ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove |
                                    ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoSavedSettings |
                                    ImGuiWindowFlags_NoBringToFrontOnFocus;

void hint(const char* text) {
    if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", text);
}

/// A button that shows whether what it stands for is on.
bool toggleButton(const char* label, bool on, const char* help) {
    if (on) ImGui::PushStyleColor(ImGuiCol_Button, ImGui::GetStyle().Colors[ImGuiCol_HeaderActive]);
    if (on) ImGui::PushStyleColor(ImGuiCol_Text, kAccent);
    const bool pressed = ImGui::Button(label);
    if (on) ImGui::PopStyleColor(2);
    hint(help);
    return pressed;
}

/// The next item stands in the same line if it is as wide as that, else in a new one.
void sameLineIfFits(float width) {
    const float right = ImGui::GetItemRectMax().x + ImGui::GetStyle().ItemSpacing.x + width;
    if (right < ImGui::GetWindowPos().x + ImGui::GetContentRegionMax().x) ImGui::SameLine();
}

void sceneCombo(Desk& desk, const Theme& theme) {
    const std::string& now = desk.bench.document().sceneName;
    const std::string shown = std::filesystem::path(now).filename().string();
    ImGui::SetNextItemWidth(kSceneComboEm * theme.em);
    if (ImGui::BeginCombo("##scene", shown.c_str(), ImGuiComboFlags_HeightLargest)) {
        for (const std::string& name : desk.scenes)
            if (ImGui::Selectable(name.c_str(), name == now)) desk.requests.scene = name;
        ImGui::EndCombo();
    }
    hint("scene (Ctrl+PageDown, Ctrl+PageUp); or drop a .json or .obj file on the window");
}

/// A button of the bar: what is written on it, whether what it stands for is on, and what it does.
struct BarButton {
    const char* label;
    bool on;
    const char* help;
    void (*press)(Desk&);
};

std::vector<BarButton> barButtons(const Desk& desk) {
    const lab::Document& document = desk.bench.document();
    const picture::StageRef& stage = document.panes[static_cast<std::size_t>(document.active)].stage;
    static const picture::StageRef kError{"error"}, kOutside{"outside"};
    const bool playing = desk.bench.animation().playing;
    return {
        {"1", document.layout == Layout::single, "single: the active pane alone (V)",
         [](Desk& d) { chooseLayout(d, Layout::single); }},
        {"1 2", document.layout == Layout::side, "two pictures side by side (V)",
         [](Desk& d) { chooseLayout(d, Layout::side); }},
        {"1|2", document.layout == Layout::split, "one picture, split by a line to be dragged (V)",
         [](Desk& d) { chooseLayout(d, Layout::split); }},
        {"2x2", document.layout == Layout::grid, "grid of four (V)", [](Desk& d) { chooseLayout(d, Layout::grid); }},
        {"1-2", document.layout == Layout::diff, "where two techniques differ, and who is right (V)",
         [](Desk& d) { chooseLayout(d, Layout::diff); }},
        {playing ? "Pause" : "Play", playing, "plays and pauses (Space)",
         [](Desk& d) { d.bench.play(!d.bench.animation().playing); }},
        {"Error", stage == kError, "where the technique is wrong (E)",
         [](Desk& d) { toggleStage(d, kError); }},
        {"Stages", desk.shown.strip, "all stages as small pictures (T)",
         [](Desk& d) { d.shown.strip = !d.shown.strip; }},
        {"Step", isStepping(desk), "the algorithm step by step (PageDown, PageUp)", [](Desk& d) { step(d, 1); }},
        {"Source", desk.shown.source, "formula, pseudocode and source of the step (Y)", toggleSource},
        {"Lens", desk.shown.magnifier, "magnifier (M)", [](Desk& d) { d.shown.magnifier = !d.shown.magnifier; }},
        {"Outside", stage == kOutside, "the second camera, which looks on from outside (O)",
         [](Desk& d) { toggleStage(d, kOutside); }},
        {"Settings", desk.shown.panel, "the panel beside the pictures (I)",
         [](Desk& d) { d.shown.panel = !d.shown.panel; }},
        {"Keys", desk.shown.keys, "all keys (H)", [](Desk& d) { d.shown.keys = !d.shown.keys; }},
    };
}

float buttonWidth(const BarButton& button) {
    return ImGui::CalcTextSize(button.label).x + 2 * ImGui::GetStyle().FramePadding.x;
}

void animationPart(Desk& desk, const Theme& theme) {
    lab::Animation animation = desk.bench.animation();
    if (toggleButton(animation.playing ? "Pause" : "Play", animation.playing, "plays and pauses (Space)"))
        desk.bench.play(!animation.playing);
    const auto part = [&](const char* label, bool lab::Animation::*member, const char* help) {
        ImGui::SameLine();
        if (ImGui::Checkbox(label, &(animation.*member))) desk.bench.setAnimation([&](auto& a) { a = animation; });
        hint(help);
    };
    part("lights", &lab::Animation::lights, "lights go around the camera's target");
    part("camera", &lab::Animation::camera, "the camera goes around its target");
    part("objects", &lab::Animation::objects, "objects that have a velocity go to and fro");
    float speed = static_cast<float>(animation.speed);
    ImGui::SetNextItemWidth(-theme.em * 4);
    if (ImGui::SliderFloat("speed", &speed, static_cast<float>(lab::kSlowest),
                           static_cast<float>(lab::kFastest), "%.2g x",
                           ImGuiSliderFlags_Logarithmic | ImGuiSliderFlags_AlwaysClamp)) // Ctrl+click takes any number
        desk.bench.setAnimation([&](lab::Animation& a) { a.speed = speed; });
    hint("half as fast (,), twice as fast (.)");
}

void techniquePart(Desk& desk) {
    const lab::Document& document = desk.bench.document();
    const lab::PaneState& state = document.panes[static_cast<std::size_t>(document.active)];
    const TechniqueInfo& info = findTechnique(state.technique);
    ImGui::SetNextItemWidth(-FLT_MIN);
    if (ImGui::BeginCombo("##technique", std::string(info.title).c_str(), ImGuiComboFlags_HeightLargest)) {
        const auto entry = [&](const RegisteredTechnique& technique, const std::string& key) {
            const std::string label = key + "  " + std::string(technique.info->title);
            if (ImGui::Selectable(label.c_str(), technique.info == &info)) chooseTechnique(desk, technique.info->id);
        };
        int number = 0;
        for (const RegisteredTechnique& technique : techniquesOf(TechniqueGroup::production))
            entry(technique, std::to_string(++number));
        ImGui::Separator();
        for (const RegisteredTechnique& technique : techniquesOf(TechniqueGroup::lecture))
            entry(technique, " ");
        ImGui::EndCombo();
    }
    hint("technique of the active pane (number keys)");
    if (sisterOf(info)) {
        if (ImGui::Button(info.sister.empty() ? "The lecture's version" : "The refined version")) chooseSister(desk);
        hint("the algorithm as the lecture has it, and back (Shift+L)");
    }
    ImGui::PushTextWrapPos();
    ImGui::TextDisabled("%s", std::string(info.paper).c_str());
    ImGui::TextDisabled("gets wrong: %s", std::string(info.getsWrong).c_str());
    ImGui::PopTextWrapPos();
}

void stagePart(Desk& desk) {
    const lab::Document& document = desk.bench.document();
    const lab::PaneState& state = document.panes[static_cast<std::size_t>(document.active)];
    const TechniqueInfo& info = findTechnique(state.technique);
    const picture::StageRef now = state.stage.ofAnyLight();
    const std::string shown = now.isPass        ? "after a step"
                              : now.isPicture() ? "the finished picture"
                                                : picture::captionOf(info, now.id);
    ImGui::SetNextItemWidth(-FLT_MIN);
    if (ImGui::BeginCombo("##stage", shown.c_str(), ImGuiComboFlags_HeightLargest)) {
        if (ImGui::Selectable("the finished picture", now.isPicture())) chooseStage(desk, {});
        for (const StageInfo& stage : picture::stagesOf(info)) {
            const picture::StageRef one{std::string(stage.id)};
            if (ImGui::Selectable(std::string(stage.caption).c_str(), now == one)) chooseStage(desk, one);
        }
        ImGui::EndCombo();
    }
    hint("what is shown of the technique (T: all stages as small pictures)");
    const auto& lights = desk.bench.shownScene()->lights;
    if (lights.size() < 2) return;
    ImGui::SetNextItemWidth(-FLT_MIN);
    const auto light = static_cast<std::size_t>(document.light);
    if (ImGui::BeginCombo("##light", ("light: " + lights[std::min(light, lights.size() - 1)].name).c_str())) {
        for (std::size_t i = 0; i < lights.size(); ++i)
            if (ImGui::Selectable(lights[i].name.c_str(), i == light))
                desk.bench.change("", [&](lab::Document& d) { d.light = static_cast<int>(i); });
        ImGui::EndCombo();
    }
    hint("the light that stages and errors are about (L)");
}

void timesPart(const Desk& desk) {
    const picture::RenderedFrame& frame = desk.bench.pane(desk.bench.document().active).rendered();
    if (!ImGui::BeginTable("times", 2)) return;
    ImGui::TableSetupColumn("what", ImGuiTableColumnFlags_WidthStretch, 0.62f);
    ImGui::TableSetupColumn("ms", ImGuiTableColumnFlags_WidthStretch, 0.38f);
    const auto row = [](const std::string& name, const char* format, auto... values) {
        ImGui::TableNextRow();
        ImGui::TableNextColumn();
        ImGui::TextUnformatted(name.c_str());
        ImGui::TableNextColumn();
        ImGui::Text(format, values...);
    };
    const auto time = [&](const std::string& name, double ms) {
        if (desk.live)
            row(name, "%.1f ms", ms);
        else
            row(name, "- ms");
    };
    time("frame", frame.frameMs);
    time("  prepare", frame.prepareMs);
    for (const gl::PassTimer::Result& pass : frame.result.passMs)
        time("  " + pass.name, pass.elapsedMs);
    for (const Counter& counter : frame.result.counters)
        if (counter.of >= 1e4) // pixels: no room for both numbers, and nobody reads them
            row(counter.id, "%.1f %% %s", 100 * counter.built / counter.of, counter.unit.c_str());
        else if (counter.of > 0)
            row(counter.id, "%.0f of %.0f %s", counter.built, counter.of, counter.unit.c_str());
        else
            row(counter.id, "%.0f %s", counter.built, counter.unit.c_str());
    ImGui::EndTable();
}

/// What the technique found in the scene, with the colours that its stages give it.
void foundPart(const Desk& desk) {
    const picture::RenderedFrame& frame = desk.bench.pane(desk.bench.document().active).rendered();
    if (frame.result.notes.empty() || !ImGui::CollapsingHeader("Found in the scene", ImGuiTreeNodeFlags_DefaultOpen))
        return;
    for (const Note& note : frame.result.notes) {
        const float side = ImGui::GetTextLineHeight();
        const ImVec2 at = ImGui::GetCursorScreenPos();
        ImGui::GetWindowDrawList()->AddRectFilled(at, {at.x + side, at.y + side}, shownColor(note.colorLinear));
        ImGui::Dummy({side, side});
        ImGui::SameLine();
        ImGui::PushTextWrapPos(0);
        ImGui::TextUnformatted((note.label + ": " + note.text).c_str());
        ImGui::PopTextWrapPos();
    }
}

} // namespace

bool beginIn(const char* name, const Area& area, ImGuiWindowFlags flags) {
    ImGui::SetNextWindowPos({static_cast<float>(area.corner.x), static_cast<float>(area.corner.y)});
    ImGui::SetNextWindowSize({static_cast<float>(area.size.x), static_cast<float>(area.size.y)});
    return ImGui::Begin(name, nullptr, kFixed | flags);
}

float topBarHeight(const Desk& desk, const Theme& theme, float width) {
    const ImGuiStyle& style = ImGui::GetStyle();
    float x = 2 * style.WindowPadding.x + kSceneComboEm * theme.em;
    int rows = 1;
    for (const BarButton& button : barButtons(desk)) {
        x += style.ItemSpacing.x + buttonWidth(button);
        if (x <= width) continue;
        ++rows;
        x = 2 * style.WindowPadding.x + buttonWidth(button);
    }
    return static_cast<float>(rows) * (ImGui::GetFrameHeight() + style.ItemSpacing.y) - style.ItemSpacing.y +
           style.WindowPadding.y;
}

void topBar(Desk& desk, const Area& area, const Theme& theme) {
    const ImGuiStyle& style = ImGui::GetStyle();
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {style.WindowPadding.x, style.WindowPadding.y * 0.5f});
    beginIn("bar", area, ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse | ImGuiWindowFlags_NoNav);
    ImGui::PopStyleVar();
    sceneCombo(desk, theme);
    float x = 2 * style.WindowPadding.x + kSceneComboEm * theme.em;
    for (const BarButton& button : barButtons(desk)) {
        x += style.ItemSpacing.x + buttonWidth(button);
        if (x <= static_cast<float>(area.size.x))
            ImGui::SameLine();
        else
            x = 2 * style.WindowPadding.x + buttonWidth(button);
        if (toggleButton(button.label, button.on, button.help)) button.press(desk);
    }
    ImGui::End();
}

void sidePanel(Desk& desk, const lab::LiveErrors& errors, const Area& area, const Theme& theme) {
    // Tab goes from pane to pane, and not into a number, unless the settings were given the keyboard.
    beginIn("settings", area, desk.panelHasKeys ? 0 : ImGuiWindowFlags_NoNav);
    if (desk.requests.focusPanel) ImGui::SetWindowFocus();
    const lab::Document& document = desk.bench.document();
    if (document.layout != Layout::single) {
        const int count = lab::shownPanes(document.layout);
        ImGui::AlignTextToFramePadding();
        ImGui::TextUnformatted("Pane");
        for (int i = 0; i < count; ++i) {
            ImGui::SameLine();
            if (toggleButton(std::to_string(i + 1).c_str(), i == document.active,
                             "the pane these settings are of (Tab)"))
                desk.bench.activate(i);
        }
    }
    techniquePart(desk);
    stagePart(desk);
    pixelPanel(desk);
    lessonList(desk);
    deckList(desk);
    if (ImGui::CollapsingHeader("Settings", ImGuiTreeNodeFlags_DefaultOpen)) parameterPanel(desk, theme);
    if (ImGui::CollapsingHeader("Errors", ImGuiTreeNodeFlags_DefaultOpen)) {
        if (desk.lesson.paints()) {
            ImGui::TextWrapped("They are shown with the truth (J).");
        } else {
            errorTable(desk, errors);
            historyPlot(desk, errors, theme);
        }
    }
    if (ImGui::CollapsingHeader("Time", ImGuiTreeNodeFlags_DefaultOpen)) timesPart(desk);
    foundPart(desk);
    if (ImGui::CollapsingHeader("Animation")) animationPart(desk, theme);
    ImGui::Separator();
    ImGui::BeginDisabled(!desk.bench.history().canUndo());
    if (ImGui::Button("Undo")) desk.bench.undo();
    hint("takes the last change back (Ctrl+Z)");
    ImGui::EndDisabled();
    ImGui::SameLine();
    ImGui::BeginDisabled(!desk.bench.history().canRedo());
    if (ImGui::Button("Redo")) desk.bench.redo();
    hint("makes it again (Ctrl+Y)");
    ImGui::EndDisabled();
    sameLineIfFits(ImGui::CalcTextSize("Save picture").x);
    if (ImGui::Button("Save picture")) desk.requests.screenshot = true;
    hint("the picture, the command line that makes it, and the scene (P)");
    sameLineIfFits(ImGui::CalcTextSize("Save scene").x);
    if (ImGui::Button("Save scene")) desk.requests.saveScene = true;
    hint("what is seen, as a scene file (Ctrl+S)");
    ImGui::End();
}

bool isStepping(const Desk& desk) {
    const lab::Document& document = desk.bench.document();
    return document.panes[static_cast<std::size_t>(document.active)].stage.isPass;
}

float stepPanelHeight(const Desk& desk, const Theme& theme, float width) {
    if (!isStepping(desk)) return 0;
    const lab::Document& document = desk.bench.document();
    const TechniqueInfo& info = findTechnique(document.panes[static_cast<std::size_t>(document.active)].technique);
    // Room for the wordiest of the technique's steps: the pictures above should not jump from step to step.
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
                         plain(pass.why) + (desk.shown.source ? 0 : plain(pseudocodeOf(info, pass))) +
                         plain("GL state: " + std::string(pass.glState)));
    return std::ceil(highest + 2 * style.WindowPadding.y + 4 * style.ItemSpacing.y);
}

void stepPanel(Desk& desk, const Area& area, const Theme& theme) {
    const lab::Document& document = desk.bench.document();
    const lab::PaneState& state = document.panes[static_cast<std::size_t>(document.active)];
    const scene::Scene& scene = *desk.bench.shownScene();
    const std::vector<StageKey>& passes = desk.bench.pane(document.active).passesOf(state.technique, scene);
    const auto now = picture::stepOf(state.stage, passes, scene, document.light);
    beginIn("step", area, ImGuiWindowFlags_NoNav);
    if (!now) {
        // Which steps run is known when they have run; in a window without room for a picture none does.
        ImGui::TextWrapped(passes.empty() ? "Nothing has been drawn yet: the window has no room for a picture."
                                          : "This step does not run with these settings; PageDown goes to the first "
                                            "that does.");
        ImGui::End();
        return;
    }
    const PassInfo& pass = passInfo(findTechnique(state.technique).passes, passes[*now].id);
    if (ImGui::ArrowButton("back", ImGuiDir_Left)) step(desk, -1);
    hint("the step before (PageUp)");
    ImGui::SameLine();
    if (ImGui::ArrowButton("on", ImGuiDir_Right)) step(desk, 1);
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
    if (!pseudocode.empty() && !desk.shown.source) { // beside the picture it is said already
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
