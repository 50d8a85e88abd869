// SPDX-License-Identifier: MIT
#include "app/window/panels/panels.h"

#include <algorithm>

#include "app/picture/derived_stages.h"
#include "app/window/panels/widgets.h"
#include "techniques/registry.h"

namespace shadowlab::window {

namespace {

/// The next item stands in the same line if it is as wide as that, else in a new one.
void sameLineIfFits(float width) {
    const float right = ImGui::GetItemRectMax().x + ImGui::GetStyle().ItemSpacing.x + width;
    if (right < ImGui::GetWindowPos().x + ImGui::GetContentRegionMax().x) ImGui::SameLine();
}

void animationPart(WindowState& ui, const Theme& theme) {
    lab::Animation animation = ui.bench.animation();
    if (toggleButton(animation.playing ? "Pause" : "Play", animation.playing, "plays and pauses (Space)"))
        ui.bench.play(!animation.playing);
    const auto part = [&](const char* label, bool lab::Animation::*member, const char* help) {
        ImGui::SameLine();
        if (ImGui::Checkbox(label, &(animation.*member))) ui.bench.setAnimation([&](auto& a) { a = animation; });
        hint(help);
    };
    part("lights", &lab::Animation::lights, "lights go around the camera's target");
    part("camera", &lab::Animation::camera, "the camera goes around its target");
    part("objects", &lab::Animation::objects, "objects that have a velocity go to and fro");
    float speed = static_cast<float>(animation.speed);
    ImGui::SetNextItemWidth(-theme.em * 4);
    if (ImGui::SliderFloat("speed", &speed, static_cast<float>(lab::kSlowest), static_cast<float>(lab::kFastest),
                           "%.2g x",
                           ImGuiSliderFlags_Logarithmic | ImGuiSliderFlags_AlwaysClamp)) // Ctrl+click takes any number
        ui.bench.setAnimation([&](lab::Animation& a) { a.speed = speed; });
    hint("half as fast (,), twice as fast (.)");
}

void techniquePart(WindowState& ui) {
    const lab::Document& document = ui.bench.document();
    const lab::PaneState& state = document.panes[static_cast<std::size_t>(document.active)];
    const TechniqueInfo& info = findTechnique(state.technique);
    ImGui::SetNextItemWidth(-FLT_MIN);
    if (ImGui::BeginCombo("##technique", std::string(info.title).c_str(), ImGuiComboFlags_HeightLargest)) {
        const auto entry = [&](const RegisteredTechnique& technique, const std::string& key) {
            const std::string label = key + "  " + std::string(technique.info->title);
            if (ImGui::Selectable(label.c_str(), technique.info == &info)) chooseTechnique(ui, technique.info->id);
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
        if (ImGui::Button(info.sister.empty() ? "The lecture's version" : "The refined version")) chooseSister(ui);
        hint("the algorithm as the lecture has it, and back (Shift+L)");
    }
    ImGui::PushTextWrapPos();
    ImGui::TextDisabled("%s", std::string(info.paper).c_str());
    ImGui::TextDisabled("gets wrong: %s", std::string(info.getsWrong).c_str());
    ImGui::PopTextWrapPos();
}

void stagePart(WindowState& ui) {
    const lab::Document& document = ui.bench.document();
    const lab::PaneState& state = document.panes[static_cast<std::size_t>(document.active)];
    const TechniqueInfo& info = findTechnique(state.technique);
    const picture::StageRef now = state.stage.ofAnyLight();
    const std::string shown = now.isPass        ? "after a step"
                              : now.isPicture() ? "the finished picture"
                                                : picture::captionOf(info, now.id);
    ImGui::SetNextItemWidth(-FLT_MIN);
    if (ImGui::BeginCombo("##stage", shown.c_str(), ImGuiComboFlags_HeightLargest)) {
        if (ImGui::Selectable("the finished picture", now.isPicture())) chooseStage(ui, {});
        for (const StageInfo& stage : picture::stagesOf(info)) {
            const picture::StageRef one{std::string(stage.id)};
            if (ImGui::Selectable(std::string(stage.caption).c_str(), now == one)) chooseStage(ui, one);
        }
        ImGui::EndCombo();
    }
    hint("what is shown of the technique (T: all stages as small pictures)");
    const auto& lights = ui.bench.shownScene()->lights;
    if (lights.size() < 2) return;
    ImGui::SetNextItemWidth(-FLT_MIN);
    const auto light = static_cast<std::size_t>(document.light);
    if (ImGui::BeginCombo("##light", ("light: " + lights[std::min(light, lights.size() - 1)].name).c_str())) {
        for (std::size_t i = 0; i < lights.size(); ++i)
            if (ImGui::Selectable(lights[i].name.c_str(), i == light))
                ui.bench.change("", [&](lab::Document& d) { d.light = static_cast<int>(i); });
        ImGui::EndCombo();
    }
    hint("the light that stages and errors are about (L)");
}

void timesPart(const WindowState& ui) {
    const picture::RenderedFrame& frame = ui.bench.pane(ui.bench.document().active).rendered();
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
        if (ui.live)
            row(name, "%.1f ms", ms);
        else
            row(name, "- ms");
    };
    time("frame", frame.frameMs);
    time("  prepare", frame.prepareMs);
    for (const gl::PassTimer::Result& pass : frame.result.passMs)
        time("  " + pass.name, pass.elapsedMs);
    for (const Counter& counter : frame.result.counters)
        if (counter.of >= 1e4) // pixels: no room for both numbers, and the share says more
            row(counter.id, "%.1f %% %s", 100 * counter.built / counter.of, counter.unit.c_str());
        else if (counter.of > 0)
            row(counter.id, "%.0f of %.0f %s", counter.built, counter.of, counter.unit.c_str());
        else
            row(counter.id, "%.0f %s", counter.built, counter.unit.c_str());
    ImGui::EndTable();
}

/// What the technique found in the scene, with the colours that its stages give it.
void foundPart(const WindowState& ui) {
    const picture::RenderedFrame& frame = ui.bench.pane(ui.bench.document().active).rendered();
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

void sidePanel(WindowState& ui, const lab::LiveErrors& errors, const Area& area, const Theme& theme) {
    // Tab goes from pane to pane, and not into a number, unless the settings were given the keyboard.
    beginIn("settings", area, ui.panelHasKeys ? 0 : ImGuiWindowFlags_NoNav);
    if (ui.requests.focusPanel) ImGui::SetWindowFocus();
    const lab::Document& document = ui.bench.document();
    if (document.layout != picture::Layout::single) {
        const int count = lab::shownPanes(document.layout);
        ImGui::AlignTextToFramePadding();
        ImGui::TextUnformatted("Pane");
        for (int i = 0; i < count; ++i) {
            ImGui::SameLine();
            if (toggleButton(std::to_string(i + 1).c_str(), i == document.active,
                             "the pane these settings are of (Tab)"))
                ui.bench.activate(i);
        }
    }
    techniquePart(ui);
    stagePart(ui);
    pixelPanel(ui);
    lessonList(ui);
    deckList(ui);
    if (ImGui::CollapsingHeader("Settings", ImGuiTreeNodeFlags_DefaultOpen)) parameterPanel(ui, theme);
    if (ImGui::CollapsingHeader("Errors", ImGuiTreeNodeFlags_DefaultOpen)) {
        if (ui.lesson.paints()) {
            ImGui::TextWrapped("They are shown with the truth (J).");
        } else {
            errorTable(ui, errors);
            historyPlot(ui, errors, theme);
        }
    }
    if (ImGui::CollapsingHeader("Time", ImGuiTreeNodeFlags_DefaultOpen)) timesPart(ui);
    foundPart(ui);
    if (ImGui::CollapsingHeader("Animation")) animationPart(ui, theme);
    ImGui::Separator();
    ImGui::BeginDisabled(!ui.bench.history().canUndo());
    if (ImGui::Button("Undo")) ui.bench.undo();
    hint("takes the last change back (Ctrl+Z)");
    ImGui::EndDisabled();
    ImGui::SameLine();
    ImGui::BeginDisabled(!ui.bench.history().canRedo());
    if (ImGui::Button("Redo")) ui.bench.redo();
    hint("makes it again (Ctrl+Y)");
    ImGui::EndDisabled();
    sameLineIfFits(ImGui::CalcTextSize("Save picture").x);
    if (ImGui::Button("Save picture")) ui.requests.screenshot = true;
    hint("the picture, the command line that makes it, and the scene (P)");
    sameLineIfFits(ImGui::CalcTextSize("Save scene").x);
    if (ImGui::Button("Save scene")) ui.requests.saveScene = true;
    hint("what is seen, as a scene file (Ctrl+S)");
    ImGui::End();
}

} // namespace shadowlab::window
