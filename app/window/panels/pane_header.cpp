// SPDX-License-Identifier: MIT
#include "app/window/panels/panels.h"

#include <algorithm>
#include <cmath>

#include "app/picture/derived_stages.h"
#include "app/picture/verdict_reasons.h"
#include "app/window/panels/widgets.h"
#include "app/window/widget_renderer.h"
#include "techniques/registry.h"

namespace shadowlab::window {

namespace {

constexpr float kTechniqueShare = 0.54f; ///< of the line, for the technique; the view has the rest

/// The settings that say which of two panes with the same technique this one is.
std::string differences(const WindowState& ui, int pane) {
    const auto& panes = ui.bench.document().panes;
    const lab::PaneState& state = panes[static_cast<std::size_t>(pane)];
    bool twice = false;
    for (int other = 0; other < lab::shownPanes(ui.bench.document().layout); ++other)
        twice = twice || (other != pane && panes[static_cast<std::size_t>(other)].technique == state.technique);
    std::string text;
    if (twice)
        for (const auto& [param, value] : state.values())
            text += (text.empty() ? "" : ", ") + param + " " + value;
    return text;
}

void techniqueMenu(WindowState& ui, int pane, float width) {
    const TechniqueInfo& info = findTechnique(ui.bench.document().panes[static_cast<std::size_t>(pane)].technique);
    const std::string differs = differences(ui, pane);
    const std::string shown = std::string(info.title) + (differs.empty() ? "" : ": " + differs);
    ImGui::SetNextItemWidth(width);
    if (ImGui::BeginCombo("##technique", shown.c_str(), ImGuiComboFlags_HeightLargest)) {
        ui.bench.activate(pane);
        const auto entry = [&](const RegisteredTechnique& technique, const std::string& key) {
            const std::string label = key + "  " + std::string(technique.info->title);
            if (ImGui::Selectable(label.c_str(), technique.info == &info)) chooseTechnique(ui, technique.info->id);
        };
        int number = 0;
        for (const RegisteredTechnique& technique : techniquesOf(TechniqueGroup::production))
            entry(technique, std::to_string(++number));
        ImGui::Separator();
        ImGui::TextDisabled("as the lecture has it (Shift+L)");
        for (const RegisteredTechnique& technique : techniquesOf(TechniqueGroup::lecture))
            entry(technique, " ");
        ImGui::EndCombo();
    }
    hint((shown + "\nthe technique of this pane (number keys)").c_str());
}

/// One line of the menu: a small picture, where there is one, and what it shows.
bool viewEntry(const std::string& caption, bool chosen, const lab::Thumbnail* thumbnail, const Theme& theme) {
    const ImVec2 size(theme.em * 4, theme.em * 2.25f);
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    const float pad = theme.em * 0.15f;
    ImGui::PushID(caption.c_str());
    const bool pressed = ImGui::Selectable("##view", chosen, 0, {0, size.y + 2 * pad});
    ImGui::PopID();
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const ImVec2 low(corner.x, corner.y + pad);
    list.AddRectFilled(low, {low.x + size.x, low.y + size.y}, IM_COL32(12, 12, 14, 255));
    if (thumbnail && thumbnail->picture.texture) {
        const ImVec2 texels = imVec(thumbnail->picture.texture.size());
        const float scale = std::min(size.x / texels.x, size.y / texels.y);
        const ImVec2 shown(texels.x * scale, texels.y * scale);
        const ImVec2 at(low.x + (size.x - shown.x) / 2, low.y + (size.y - shown.y) / 2);
        list.AddImage(imguiTexture(thumbnail->picture.texture), at, {at.x + shown.x, at.y + shown.y}, {0, 1}, {1, 0});
    }
    list.AddText({low.x + size.x + theme.em * 0.6f, low.y + (size.y - ImGui::GetTextLineHeight()) / 2},
                 chosen ? kAccent : ImGui::GetColorU32(ImGuiCol_Text), caption.c_str());
    return pressed;
}

/// True while it is open.
bool viewMenu(WindowState& ui, int pane, const lab::StageStrip& strip, float width, const Theme& theme) {
    const lab::PaneState& state = ui.bench.document().panes[static_cast<std::size_t>(pane)];
    const TechniqueInfo& info = findTechnique(state.technique);
    const bool differs = ui.bench.document().layout == picture::Layout::diff; // of finished pictures, whatever the panes show elsewhere
    const picture::StageRef now = differs ? picture::StageRef() : state.stage.ofAnyLight();
    const std::string shown = now.isPass        ? "after a step"
                              : now.isPicture() ? "the finished picture"
                                                : picture::captionOf(info, now.id);
    ImGui::SetNextItemWidth(width);
    // Wider than its button: captions are sentences. Not over all of the window, so that the list hangs below the button.
    ImGui::SetNextWindowSizeConstraints({std::max(width, 30 * theme.em), 0},
                                        {FLT_MAX, std::max(6 * theme.em, ImGui::GetIO().DisplaySize.y - 6 * theme.em)});
    const bool isOpen = ImGui::BeginCombo("##view", shown.c_str(), ImGuiComboFlags_HeightLargest);
    if (isOpen) {
        ui.bench.activate(pane);
        const auto entry = [&](const picture::StageRef& stage, const std::string& caption) {
            const auto& pictures = strip.thumbnails();
            const auto found = std::ranges::find(pictures, stage, &lab::Thumbnail::stage);
            if (viewEntry(caption, now == stage, found == pictures.end() ? nullptr : &*found, theme))
                chooseView(ui, stage);
        };
        entry({}, "the finished picture");
        const auto stages = picture::stagesOf(info);
        for (const StageInfo& stage : stages) // first what every technique has: error, truth, outside
            if (picture::isDerived(stage.id)) entry({std::string(stage.id)}, std::string(stage.caption));
        ImGui::Separator();
        for (const StageInfo& stage : stages)
            if (!picture::isDerived(stage.id)) entry({std::string(stage.id)}, std::string(stage.caption));
        ImGui::EndCombo();
    }
    hint((shown + "\nwhat this pane shows: E error, U truth, O from outside, T all stages").c_str());
    return isOpen;
}

/// "lamp: 404 wrong pixels, edge 0.21 px, 12 ms"
std::string verdictLine(const WindowState& ui, const lab::LiveErrors& errors, int pane) {
    if (ui.lesson.paints()) return "judged when the truth is shown";
    const auto& lights = ui.bench.shownScene()->lights;
    std::string text;
    if (lights.size() > 1)
        text = lights[std::min(static_cast<std::size_t>(ui.bench.document().light), lights.size() - 1)].name + ": ";
    const bool isStep = ui.bench.document().panes[static_cast<std::size_t>(pane)].stage.isPass;
    if (isStep) {
        text += "a step, not judged";
    } else if (const lab::PaneErrors* known = errors.errors(pane)) {
        const int wrong = known->counts.wrong();
        text += std::to_string(wrong) + (wrong == 1 ? " wrong pixel" : " wrong pixels");
        if (known->edgeErrorPx) text += ", edge " + picture::fixed(*known->edgeErrorPx, 2) + " px";
    } else {
        text += "not judged yet";
    }
    if (ui.live && ui.showsTimes) text += ", " + std::to_string(std::lround(ui.bench.pane(pane).rendered().frameMs)) + " ms";
    return text;
}

void verdict(const WindowState& ui, const lab::LiveErrors& errors, const PaneHeader& header, int lines) {
    const std::string text = verdictLine(ui, errors, header.pane);
    if (lines == 1) {
        const float right = static_cast<float>(header.area.size.x) - ImGui::GetStyle().WindowPadding.x;
        ImGui::SameLine();
        ImGui::SetCursorPosX(std::max(ImGui::GetCursorPosX(), right - ImGui::CalcTextSize(text.c_str()).x));
        ImGui::AlignTextToFramePadding();
    }
    ImGui::TextUnformatted(text.c_str());
    const lab::PaneErrors* const known = errors.errors(header.pane);
    if (!ImGui::IsItemHovered() || !known || ui.lesson.paints()) return;
    ImGui::SetTooltip("of the whole picture: %d pixels lit that are in shadow, %d in shadow that are lit%s\n"
                      "edge: how far on average the shadow's edge is from where it belongs, in pixels",
                      known->counts.falseLit, known->counts.falseShadow, known->exact ? "" : "\nexact when all is at rest");
}

} // namespace

bool paneHeader(WindowState& ui, const lab::LiveErrors& errors, const lab::StageStrip& strip, const PaneHeader& header, int lines,
                const Theme& theme) {
    const ImGuiStyle& style = ImGui::GetStyle();
    const float inset = theme.em * 0.5f;
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {inset, theme.em * 0.12f});
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {style.FramePadding.x, theme.em * 0.1f});
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {theme.em * 0.4f, theme.em * 0.15f});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 0);
    beginIn(("pane " + std::to_string(header.pane + 1)).c_str(), header.area,
            ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse | ImGuiWindowFlags_NoNav);
    const bool several = lab::shownPanes(ui.bench.document().layout) > 1;
    if (several && header.pane == ui.bench.document().active) {
        const ImVec2 low = ImGui::GetWindowPos();
        ImGui::GetWindowDrawList()->AddRectFilled(
            low, {low.x + std::max(3.0f, theme.em * 0.2f), low.y + static_cast<float>(header.area.size.y)}, kAccent);
    }
    if (ImGui::IsWindowHovered() && ImGui::IsMouseClicked(0)) ui.bench.activate(header.pane);
    float room = static_cast<float>(header.area.size.x) - 2 * inset - style.ItemSpacing.x;
    if (lines == 1) // beside a long verdict
        room -= ImGui::CalcTextSize("cool lamp: 9999 wrong pixels, edge 0.00 px, 999 ms").x;
    room = std::min(room, theme.em * 34);
    techniqueMenu(ui, header.pane, std::round(room * kTechniqueShare));
    ImGui::SameLine();
    const bool isOpen = viewMenu(ui, header.pane, strip, std::round(room * (1 - kTechniqueShare)), theme);
    verdict(ui, errors, header, lines);
    ImGui::End();
    ImGui::PopStyleVar(4);
    return isOpen;
}

} // namespace shadowlab::window
