// SPDX-License-Identifier: MIT
#include "app/window/panels/story_bar.h"

#include <algorithm>
#include <cmath>

#include "app/window/panels/prose_text.h"
#include "app/window/panels/widgets.h"
#include "app/window/widget_renderer.h"

namespace shadowlab::window {

namespace {

constexpr const char* kExploreHint = "PageDown: the algorithm step by step";

/// The modes, side by side. Lessons and slides are chosen from a menu.
void tabs(WindowState& ui) {
    const StoryMode mode = storyMode(ui);
    for (const StoryTab& tab : kStoryTabs) {
        if (tab.mode != StoryMode::explore) ImGui::SameLine(0, 1);
        const bool isOn = tab.mode == mode || tab.mode == outerMode(ui);
        if (!toggleButton(tab.label, tab.mode == StoryMode::explore ? mode == tab.mode : isOn, tab.help)) continue;
        if (tab.mode == StoryMode::explore) explore(ui);
        if (tab.mode == StoryMode::steps && mode != StoryMode::steps) goThroughSteps(ui, 1);
        if (tab.mode == StoryMode::lesson) ImGui::OpenPopup("lessons");
        if (tab.mode == StoryMode::slides) ImGui::OpenPopup("slides");
    }
    const float most = 0.7f * ImGui::GetIO().DisplaySize.y; // a longer list scrolls
    for (const char* name : {"lessons", "slides"}) {
        ImGui::SetNextWindowSizeConstraints({0, 0}, {FLT_MAX, most});
        if (!ImGui::BeginPopup(name)) continue;
        if (*name == 'l')
            lessonChoices(ui);
        else
            deckChoices(ui);
        ImGui::EndPopup();
    }
}

void drawLine(WindowState& ui, const StoryLine& line, int choice, float width, const Theme& theme) {
    const ImVec4 accent = ImGui::ColorConvertU32ToFloat4(kAccent);
    if (!line.written.empty()) {
        proseText(line.written, width, line.kind == StoryLine::Kind::accent ? kAccent : ImGui::GetColorU32(ImGuiCol_Text), theme);
        return;
    }
    switch (line.kind) {
    case StoryLine::Kind::text: ImGui::TextWrapped("%s", line.text.c_str()); break;
    case StoryLine::Kind::quiet:
        ImGui::PushStyleColor(ImGuiCol_Text, ImGui::GetStyle().Colors[ImGuiCol_TextDisabled]);
        ImGui::TextWrapped("%s", line.text.c_str());
        ImGui::PopStyleColor();
        break;
    case StoryLine::Kind::accent:
        ImGui::PushStyleColor(ImGuiCol_Text, accent);
        ImGui::TextWrapped("%s", line.text.c_str());
        ImGui::PopStyleColor();
        break;
    case StoryLine::Kind::large:
        ImGui::PushFont(theme.heading);
        ImGui::TextWrapped("%s", line.text.c_str());
        ImGui::PopFont();
        break;
    case StoryLine::Kind::choice:
        if (ImGui::Selectable(line.text.c_str(), line.isChosen)) answer(ui, choice);
        break;
    case StoryLine::Kind::key: {
        const ImVec2 at = ImGui::GetCursorScreenPos();
        ImGui::GetWindowDrawList()->AddRectFilled(at, {at.x + theme.em, at.y + theme.em}, line.color);
        ImGui::Dummy({theme.em, theme.em});
        ImGui::SameLine();
        ImGui::TextUnformatted(line.text.c_str());
        break;
    }
    }
}

void drawCode(const StoryPage& page, const Theme& theme) {
    ImGui::PushFont(theme.code);
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {0, codeGap(theme)});
    for (const CodeLine& line : page.code) {
        if (line.isMarked) ImGui::PushStyleColor(ImGuiCol_Text, kAccent);
        ImGui::TextWrapped("%s", line.text.empty() ? " " : line.text.c_str());
        if (line.isMarked) ImGui::PopStyleColor();
    }
    ImGui::PopStyleVar();
    ImGui::PopFont();
}

/// Wrapped at that width.
void drawTitle(const StoryPage& page, float width, const Theme& theme) {
    if (!page.writtenTitle.empty()) return proseText(page.writtenTitle, width, ImGui::GetColorU32(ImGuiCol_Text), forHeading(theme));
    ImGui::PushFont(theme.heading);
    ImGui::TextWrapped("%s", page.title.c_str());
    ImGui::PopFont();
}

/// Arrows, place, title, tabs, the way out. Returns which arrow was clicked: -1, 1, or 0.
int drawFirstRow(WindowState& ui, const StoryPage& page, const BandShape& row, float width, const Theme& theme) {
    const ImGuiStyle& style = ImGui::GetStyle();
    const std::string leave = leaveLabel(ui);
    int by = 0;
    if (!row.hasTabs) tabs(ui);
    if (ImGui::ArrowButton("back", ImGuiDir_Left)) by = -1;
    hint("the one before (PageUp)");
    ImGui::SameLine();
    ImGui::TextColored(ImGui::ColorConvertU32ToFloat4(kAccent), "%s", (row.hasShortPlace ? page.shortPlace : page.place).c_str());
    ImGui::SameLine(style.WindowPadding.x + row.controls - ImGui::GetFrameHeight() - style.ItemSpacing.x);
    if (ImGui::ArrowButton("on", ImGuiDir_Right)) by = 1;
    hint("the next one (PageDown)");
    if (row.hasTitle) {
        ImGui::SameLine(style.WindowPadding.x + row.controls);
        drawTitle(page, titleWidth(page, theme) + 1, theme); // no line is broken
    }
    const float right = style.WindowPadding.x + width;
    if (row.hasTabs) {
        ImGui::SameLine(right - storyButtonWidth(leave) - style.ItemSpacing.x - storyTabsWidth());
        tabs(ui);
    }
    if (row.hasLeave) {
        ImGui::SameLine(right - storyButtonWidth(leave));
        if (ImGui::Button(leave.c_str())) leaveStory(ui);
    }
    return by;
}

void drawThinBand(WindowState& ui, const Area& area) {
    const ImGuiStyle& style = ImGui::GetStyle();
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {style.WindowPadding.x, style.WindowPadding.y / 2});
    beginIn("story", area, ImGuiWindowFlags_NoNav | ImGuiWindowFlags_NoScrollbar);
    ImGui::PopStyleVar();
    tabs(ui);
    const float free = static_cast<float>(area.size.x) - 2 * style.WindowPadding.x - storyTabsWidth() - 2 * style.ItemSpacing.x;
    const float hintWidth = ImGui::CalcTextSize(kExploreHint).x;
    if (hintWidth <= free && storyMode(ui) == StoryMode::explore) {
        ImGui::SameLine(static_cast<float>(area.size.x) - style.WindowPadding.x - hintWidth);
        ImGui::AlignTextToFramePadding();
        ImGui::TextDisabled("%s", kExploreHint);
    }
    ImGui::End();
}

void drawBand(WindowState& ui, const Area& area, float typeShare, const Theme& theme) {
    const ImGuiStyle& style = ImGui::GetStyle();
    const std::vector<StoryPage> pages = pagesOfBand(ui);
    const StoryPage& page = pages.back();
    const float width = std::max(theme.em, static_cast<float>(area.size.x) - 2 * style.WindowPadding.x);
    const BandShape row = bandShape(ui, pages, width, typeShare, theme);
    const Theme smaller = withType(theme, typeShare);
    beginIn("story", area, ImGuiWindowFlags_NoNav);
    const float free = ImGui::GetContentRegionAvail().x; // without a scrollbar's width
    ImGui::SetWindowFontScale(1);
    const int by = drawFirstRow(ui, page, row, free, theme);
    ImGui::SetWindowFontScale(typeShare);
    if (!row.hasTitle) drawTitle(page, free, smaller);
    const float textWidth = row.textShare * free;
    const ImVec2 top = ImGui::GetCursorPos();
    ImGui::PushTextWrapPos(style.WindowPadding.x + textWidth);
    int choice = 0;
    for (const StoryLine& line : page.lines) {
        drawLine(ui, line, choice, textWidth, smaller);
        if (line.kind == StoryLine::Kind::choice) ++choice;
    }
    ImGui::PopTextWrapPos();
    if (row.hasColumns) ImGui::SetCursorPos({style.WindowPadding.x + textWidth + smaller.em, top.y});
    ImGui::BeginGroup();
    drawCode(page, smaller);
    ImGui::EndGroup();
    ImGui::SetWindowFontScale(1); // it is kept, also for the thin band
    ImGui::End();
    if (by != 0) goThroughStory(ui, by);
}

/// The drawing on paper, as large as there is room, in the middle.
void drawFigure(const SlideFigure& figure, const Area& area) {
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {0, 0});
    ImGui::PushStyleColor(ImGuiCol_WindowBg, IM_COL32_WHITE);
    beginIn("drawing", area, ImGuiWindowFlags_NoNav | ImGuiWindowFlags_NoScrollbar);
    if (const gl::Texture2D& texture = figure.texture()) {
        const ImVec2 size = imVec(texture.size());
        ImGui::SetCursorPos({std::round((static_cast<float>(area.size.x) - size.x) / 2),
                             std::round((static_cast<float>(area.size.y) - size.y) / 2)});
        ImGui::Image(imguiTexture(texture), size, {0, 1}, {1, 0});
    } else {
        ImGui::SetCursorPos({ImGui::GetStyle().ItemSpacing.x, ImGui::GetStyle().ItemSpacing.y});
        ImGui::PushStyleColor(ImGuiCol_Text, IM_COL32(26, 26, 26, 255));
        ImGui::PushTextWrapPos(static_cast<float>(area.size.x));
        ImGui::TextUnformatted(figure.fault().empty() ? "drawing ..." : figure.fault().c_str());
        ImGui::PopTextWrapPos();
        ImGui::PopStyleColor();
    }
    ImGui::End();
    ImGui::PopStyleColor();
    ImGui::PopStyleVar();
}

} // namespace

void storyBar(WindowState& ui, const SlideFigure& figure, const StoryLayout& layout, const Theme& theme) {
    if (layout.figure.size.x > 0 && layout.figure.size.y > 0) drawFigure(figure, layout.figure);
    if (layout.band.size.x < 1 || layout.band.size.y < 1) return;
    if (storyMode(ui) == StoryMode::explore)
        drawThinBand(ui, layout.band);
    else
        drawBand(ui, layout.band, layout.typeShare, theme);
}

} // namespace shadowlab::window
