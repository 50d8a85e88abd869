// SPDX-License-Identifier: MIT
#include "app/window/panels/panels.h"

#include <algorithm>

#include "app/picture/derived_stages.h"
#include "app/window/panels/widgets.h"
#include "techniques/registry.h"

namespace shadowlab::window {

namespace {

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

/// What the technique is called, whose it is, and what it gets wrong.
void techniquePart(WindowState& ui) {
    const TechniqueInfo& info = findTechnique(ui.bench.activeState().technique);
    ImGui::PushTextWrapPos();
    ImGui::TextUnformatted(std::string(info.title).c_str());
    ImGui::TextDisabled("%s", std::string(info.paper).c_str());
    ImGui::TextDisabled("gets wrong: %s", std::string(info.getsWrong).c_str());
    ImGui::PopTextWrapPos();
    if (!sisterOf(info)) return;
    if (ImGui::Button(info.sister.empty() ? "The lecture's version" : "The refined version")) chooseSister(ui);
    hint("the algorithm as the lecture has it, and back (Shift+L)");
}

/// The light that stages and errors are about, where there are several.
void lightPart(WindowState& ui) {
    const auto& lights = ui.bench.shownScene()->lights;
    if (lights.size() < 2) return;
    ImGui::SetNextItemWidth(-FLT_MIN);
    const auto light = static_cast<std::size_t>(ui.bench.document().light);
    if (ImGui::BeginCombo("##light", ("light: " + lights[std::min(light, lights.size() - 1)].name).c_str())) {
        for (std::size_t i = 0; i < lights.size(); ++i)
            if (ImGui::Selectable(lights[i].name.c_str(), i == light))
                ui.bench.change("", [&](lab::Document& d) { d.light = static_cast<int>(i); });
        ImGui::EndCombo();
    }
    hint("the light that stages and errors are about (L)");
}

/// The panes, to choose the one that the panel is about.
void panePart(WindowState& ui) {
    const int count = lab::shownPanes(ui.bench.document().layout);
    if (count < 2) return;
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted("Pane");
    for (int i = 0; i < count; ++i) {
        ImGui::SameLine();
        if (toggleButton(std::to_string(i + 1).c_str(), i == ui.bench.document().active,
                         "the pane that this panel is about (Tab)"))
            ui.bench.activate(i);
    }
}

void verdictPart(WindowState& ui, const lab::LiveErrors& errors) {
    ImGui::TextColored(ImGui::ColorConvertU32ToFloat4(kAccent), "Verdict");
    lightPart(ui);
    if (ui.lesson.paints())
        ImGui::TextWrapped("It is shown with the truth (J).");
    else
        errorTable(ui, errors);
    ImGui::Spacing();
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
        if (ui.live && ui.showsTimes)
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
    if (frame.result.notes.empty()) return;
    ImGui::TextUnformatted("Found in the scene");
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

void panelTabs(WindowState& ui) {
    if (toggleButton("Panel", !ui.shown.source, "verdict, settings, details (I)") && ui.shown.source) {
        toggleSource(ui);
        ui.shown.panel = true;
    }
    ImGui::SameLine();
    if (toggleButton("Source", ui.shown.source, "formula, pseudocode and source of the step (Y)")) toggleSource(ui);
}

void sidePanel(WindowState& ui, const lab::LiveErrors& errors, const Area& area, const Theme& theme) {
    // Tab goes from pane to pane, and not into a number, unless the settings were given the keyboard.
    beginIn("settings", area, ui.panelHasKeys ? 0 : ImGuiWindowFlags_NoNav);
    if (ui.requests.focusPanel) ImGui::SetWindowFocus();
    panelTabs(ui);
    panePart(ui);
    verdictPart(ui, errors);
    if (looksFromOutside(ui)) outsidePanel(ui);
    pixelPanel(ui);
    if (ImGui::CollapsingHeader("Settings", ImGuiTreeNodeFlags_DefaultOpen)) parameterPanel(ui, theme);
    if (ImGui::CollapsingHeader("Animation")) animationPart(ui, theme);
    if (ImGui::CollapsingHeader("Details")) {
        techniquePart(ui);
        if (!ui.lesson.paints()) historyPlot(ui, errors, theme);
        timesPart(ui);
        foundPart(ui);
    }
    ImGui::End();
}

} // namespace shadowlab::window
