// SPDX-License-Identifier: MIT
#include "app/window/panels/panels.h"

#include <algorithm>
#include <cmath>

#include "app/picture/derived_stages.h"
#include "app/window/actions.h"
#include "app/window/panels/pane_verdict.h"
#include "app/window/panels/widgets.h"
#include "app/window/widget_renderer.h"
#include "techniques/registry.h"

namespace shadowlab::window {

namespace {

constexpr float kTechniqueShare = 0.54f; ///< of the line at least, where not all fits; the view has the rest

/// The settings that say which of two panes with the same technique this one is: those that are not the same in both.
std::string differences(const WindowState& ui, int pane) {
    const auto& panes = ui.bench.document().panes;
    const lab::PaneState& state = panes[static_cast<std::size_t>(pane)];
    std::string text;
    for (const auto& [param, value] : state.values()) {
        bool differs = false;
        for (int other = 0; other < lab::shownPanes(ui.bench.document().layout); ++other) {
            const lab::PaneState& theirs = panes[static_cast<std::size_t>(other)];
            if (other == pane || theirs.technique != state.technique) continue;
            const auto found = theirs.values().find(param);
            differs = differs || found == theirs.values().end() || found->second != value;
        }
        if (differs) text += (text.empty() ? "" : ", ") + param + " " + value;
    }
    return text;
}

/// What a pane is called, and how that is made shorter.
struct Title {
    std::string technique, settings; ///< settings: those that tell it from another pane; they are cut last
    std::string view, shortView;     ///< what is shown of it

    [[nodiscard]] std::string whole() const { return technique + (settings.empty() ? "" : ": " + settings); }
    [[nodiscard]] std::string techniqueIn(float width) const {
        if (settings.empty() || ImGui::CalcTextSize(whole().c_str()).x <= width) return cutTo(whole(), width);
        const std::string end = ": " + settings;
        const float rest = width - ImGui::CalcTextSize(end.c_str()).x;
        return rest > 3 * ImGui::GetFontSize() ? cutTo(technique, rest) + end : cutTo(settings, width);
    }
    [[nodiscard]] std::string viewIn(float width) const {
        return ImGui::CalcTextSize(view.c_str()).x <= width ? view : cutTo(shortView, width);
    }
};

/// What a caption says first: "Depth from the light" of "Depth from the light: the shadow map".
std::string beginningOf(const std::string& caption) {
    std::size_t end = caption.size();
    for (const char* const mark : {": ", ", ", "; ", " ("})
        end = std::min(end, caption.find(mark));
    return caption.substr(0, end);
}

Title titleOf(const WindowState& ui, int pane) {
    const lab::PaneState& state = ui.bench.document().panes[static_cast<std::size_t>(pane)];
    const TechniqueInfo& info = findTechnique(state.technique);
    Title title{std::string(info.title), differences(ui, pane), {}, {}};
    if (ui.bench.document().layout == picture::Layout::diff) { // of finished pictures, whatever the panes show elsewhere
        title.view = "compared: its wrong pixels";
        title.shortView = "compared";
    } else if (state.stage.isPass) {
        // Just after another technique was chosen, the step may be one that it does not have.
        const auto pass = std::ranges::find(info.passes, state.stage.id, &PassInfo::id);
        title.shortView = "after a step";
        title.view = pass == info.passes.end() ? title.shortView : "after: " + std::string(pass->title);
    } else if (state.stage.ofAnyLight().isPicture()) {
        title.view = "the finished picture";
        title.shortView = "finished";
    } else {
        const std::string light = state.stage.light ? *state.stage.light + ": " : "";
        const std::string caption = picture::captionOf(info, state.stage.id);
        title.view = light + caption;
        title.shortView = light + beginningOf(caption);
    }
    return title;
}

/// How the line of the two menus is divided.
struct MenuWidths {
    float technique = 0, view = 0;
    bool hasArrows = true;
};

/// Each as wide as its text, if both fit into the room; else the view is made shorter first.
MenuWidths menuWidths(const Title& title, float room, bool isCompact) {
    const ImGuiStyle& style = ImGui::GetStyle();
    const auto needed = [&](const std::string& text, bool arrow) {
        return std::ceil(ImGui::CalcTextSize(text.c_str()).x + 2 * style.FramePadding.x + (arrow ? ImGui::GetFrameHeight() : 0) + 1);
    };
    MenuWidths widths;
    widths.hasArrows = !isCompact && needed(title.whole(), true) + needed(title.shortView, true) + style.ItemSpacing.x <= room;
    room -= style.ItemSpacing.x;
    const float technique = needed(title.whole(), widths.hasArrows), view = needed(title.view, widths.hasArrows);
    if (technique + view <= room) {
        // Equal headers have equal menus; in a compact one the verdict needs the room.
        const float share = isCompact ? technique : std::max(technique, std::min(room - view, std::round(room * kTechniqueShare)));
        widths.technique = share;
        widths.view = isCompact ? view : room - share;
        return widths;
    }
    const float least = std::min(needed(title.shortView, widths.hasArrows), std::round(room * (1 - kTechniqueShare)));
    widths.technique = std::min(technique, room - least);
    widths.view = room - widths.technique;
    return widths;
}

/// Of a menu's button, for its text.
float textRoom(float width, bool hasArrow) {
    return width - 2 * ImGui::GetStyle().FramePadding.x - (hasArrow ? ImGui::GetFrameHeight() : 0);
}

ImGuiComboFlags menuFlags(bool hasArrow) { return ImGuiComboFlags_HeightLargest | (hasArrow ? 0 : ImGuiComboFlags_NoArrowButton); }

/// A list opened in a header of smaller type is as large as all others.
void endSmallType(float typeShare) { ImGui::SetWindowFontScale(1 / typeShare); }

void techniqueMenu(WindowState& ui, int pane, const Title& title, const MenuWidths& widths, float typeShare) {
    const TechniqueInfo& info = findTechnique(ui.bench.document().panes[static_cast<std::size_t>(pane)].technique);
    ImGui::SetNextItemWidth(widths.technique);
    const std::string shown = title.techniqueIn(textRoom(widths.technique, widths.hasArrows));
    if (ImGui::BeginCombo("##technique", shown.c_str(), menuFlags(widths.hasArrows))) {
        endSmallType(typeShare);
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
    hint((title.whole() + "\nthe technique of this pane (number keys)").c_str());
}

/// The key that shows a stage which every technique has; empty where there is none.
std::string keyOf(std::string_view stage) {
    if (!picture::isDerived(stage)) return "";
    const auto known = actions();
    const auto found = std::ranges::find(known, stage, [](const Action& action) { return std::string_view(action.id); });
    return found == known.end() ? "" : found->keys;
}

/// One line of the menu: a small picture, where there is one, what it shows, and its key.
bool viewEntry(const std::string& caption, const std::string& key, bool chosen, const lab::Thumbnail* thumbnail, const Theme& theme) {
    const ImVec2 size(theme.em * 4, theme.em * 2.25f);
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    const float pad = theme.em * 0.15f;
    ImGui::PushID(caption.c_str());
    const bool pressed = ImGui::Selectable("##view", chosen, 0, {0, size.y + 2 * pad});
    const float right = ImGui::GetItemRectMax().x - theme.em * 0.5f;
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
    list.AddText({right - ImGui::CalcTextSize(key.c_str()).x, low.y + (size.y - ImGui::GetTextLineHeight()) / 2},
                 ImGui::GetColorU32(ImGuiCol_TextDisabled), key.c_str());
    return pressed;
}

/// True while it is open.
bool viewMenu(WindowState& ui, int pane, const lab::StageStrip& strip, const Title& title, const MenuWidths& widths,
              float typeShare, const Theme& theme) {
    const lab::PaneState& state = ui.bench.document().panes[static_cast<std::size_t>(pane)];
    const TechniqueInfo& info = findTechnique(state.technique);
    const bool differs = ui.bench.document().layout == picture::Layout::diff; // of finished pictures, whatever the panes show elsewhere
    const picture::StageRef now = differs ? picture::StageRef() : state.stage.ofAnyLight();
    const std::string shown = title.viewIn(textRoom(widths.view, widths.hasArrows));
    ImGui::SetNextItemWidth(widths.view);
    // Wider than its button: captions are sentences. Not over all of the window, so that the list hangs below the button.
    ImGui::SetNextWindowSizeConstraints({std::max(widths.view, 30 * theme.em), 0},
                                        {FLT_MAX, std::max(6 * theme.em, ImGui::GetIO().DisplaySize.y - 6 * theme.em)});
    const bool isOpen = ImGui::BeginCombo("##view", shown.c_str(), menuFlags(widths.hasArrows));
    if (isOpen) {
        endSmallType(typeShare);
        ui.bench.activate(pane);
        const auto entry = [&](const picture::StageRef& stage, const std::string& caption) {
            const auto& pictures = strip.thumbnails();
            const auto found = std::ranges::find(pictures, stage, &lab::Thumbnail::stage);
            if (viewEntry(caption, keyOf(stage.id), now == stage, found == pictures.end() ? nullptr : &*found, theme))
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
    hint((title.view + "\nwhat this pane shows: E error, U truth, O from outside, T all stages").c_str());
    return isOpen;
}

/// The pane that keys and panels are about, where there are several.
void markActive(const PaneHeader& header, const Theme& theme) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const ImVec2 low = ImGui::GetWindowPos();
    list.PushClipRectFullScreen(); // the line lies in the window's padding
    list.AddRectFilled(low, {low.x + static_cast<float>(header.area.size.x), low.y + std::max(3.0f, std::round(theme.em * 0.16f))}, kAccent);
    list.PopClipRect();
}

float insetOf(const Theme& theme) { return theme.em * 0.5f; }

/// Width of the line of menus, where a verdict stands beside them.
float menuRoom(const WindowState& ui, const lab::LiveErrors& errors, const PaneHeader& header, const PaneFrames& frames, float spacing,
               float typeShare, const Theme& theme) {
    float room = static_cast<float>(header.area.size.x) - 2 * insetOf(theme);
    if (frames.headerLines == 1) room -= typeShare * verdictRoom(ui, errors, header.pane, frames.isCompact) + spacing;
    return std::min(room, theme.em * 40);
}

constexpr float kHeaderSpacingEm = 0.4f;

} // namespace

float headerTypeShare(const WindowState& ui, const lab::LiveErrors& errors, const PaneFrames& frames, const Theme& theme) {
    const float spacing = kHeaderSpacingEm * theme.em;
    const auto fits = [&](const PaneHeader& header, float share) {
        const Title title = titleOf(ui, header.pane);
        const float words = ImGui::CalcTextSize(title.whole().c_str()).x + ImGui::CalcTextSize(title.shortView.c_str()).x;
        return share * words + 4 * ImGui::GetStyle().FramePadding.x + spacing + 2 <=
               menuRoom(ui, errors, header, frames, spacing, share, theme);
    };
    const std::vector<PaneHeader> headers = paneHeaders(ui, frames);
    for (float share = 1; share >= kSmallestType; share -= kTypeStep)
        if (std::ranges::all_of(headers, [&](const PaneHeader& header) { return fits(header, share); })) return share;
    return kSmallestType;
}

bool paneHeader(WindowState& ui, const lab::LiveErrors& errors, const lab::StageStrip& strip, const PaneHeader& header,
                const PaneFrames& frames, float typeShare, const Theme& theme) {
    const ImGuiStyle& style = ImGui::GetStyle();
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {insetOf(theme), theme.em * 0.2f});
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {style.FramePadding.x, theme.em * (frames.isCompact ? 0.03f : 0.08f)});
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {theme.em * kHeaderSpacingEm, theme.em * 0.1f});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 0);
    beginIn(("pane " + std::to_string(header.pane + 1)).c_str(), header.area,
            ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse | ImGuiWindowFlags_NoNav);
    ImGui::SetWindowFontScale(typeShare);
    if (lab::shownPanes(ui.bench.document().layout) > 1 && header.pane == ui.bench.document().active) markActive(header, theme);
    if (ImGui::IsWindowHovered() && ImGui::IsMouseClicked(0)) ui.bench.activate(header.pane);
    const float room = menuRoom(ui, errors, header, frames, style.ItemSpacing.x, 1, theme); // the verdict is measured in this type
    const Title title = titleOf(ui, header.pane);
    const MenuWidths widths = menuWidths(title, room, frames.isCompact);
    techniqueMenu(ui, header.pane, title, widths, typeShare);
    ImGui::SameLine();
    const bool isOpen = viewMenu(ui, header.pane, strip, title, widths, typeShare, theme);
    drawVerdict(ui, errors, header, frames.headerLines == 1);
    ImGui::End();
    ImGui::PopStyleVar(4);
    return isOpen;
}

} // namespace shadowlab::window
