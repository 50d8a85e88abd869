// SPDX-License-Identifier: MIT
#include "app/window/panels/story_bar.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "app/course/lessons/lesson.h"
#include "app/window/panels/story_page.h"
#include "app/window/panels/widgets.h"
#include "app/window/widget_renderer.h"

namespace shadowlab::window {

namespace {

constexpr float kMostOfRoom = 0.45f;    ///< of the height: longer texts scroll, and the pictures keep the larger part
constexpr float kLeastRoomEm = 16;      ///< height below which a band that tells nothing is left out
constexpr float kLeastForColumnsEm = 34; ///< width below which pseudocode stands below the text and not beside it
constexpr float kTextShare = 0.5f;      ///< of the width, beside pseudocode, whose lines are long
constexpr float kPictureShare = 0.42f;  ///< of the width, beside a drawing; its type has to be read as well

struct Tab {
    StoryMode mode;
    const char *label, *help;
};
constexpr std::array<Tab, 4> kTabs = {{
    {StoryMode::explore, "Explore", "nothing is told: the scene, the techniques and their settings (Esc)"},
    {StoryMode::steps, "Steps", "the algorithm step by step (N; PageDown, PageUp)"},
    {StoryMode::lesson, "Lessons", "an artefact and its remedy, chapter by chapter (J)"},
    {StoryMode::slides, "Slides", "the lectures' slides, live (S)"},
}};

constexpr const char* kExploreHint = "PageDown: the algorithm step by step";

std::string leaveLabel(const WindowState& ui) {
    switch (outerMode(ui)) {
    case StoryMode::lesson: return "Esc: to the lesson";
    case StoryMode::slides: return "Esc: to the slide";
    default: return "Esc: leave";
    }
}

StoryPage pageOf(const WindowState& ui) {
    switch (storyMode(ui)) {
    case StoryMode::steps: return stepPage(ui);
    case StoryMode::lesson: return lessonPage(ui);
    case StoryMode::slides: return slidePage(ui);
    case StoryMode::explore: break;
    }
    return {};
}

/// The page on show, and those that the band keeps room for, so that the pictures do not jump from one to the next.
std::vector<StoryPage> pagesOf(const WindowState& ui) {
    std::vector<StoryPage> pages;
    if (storyMode(ui) == StoryMode::steps) pages = stepPages(ui);
    if (storyMode(ui) == StoryMode::lesson) pages = lessonPages(ui);
    pages.push_back(pageOf(ui));
    return pages;
}

float buttonWidth(const std::string& label) {
    return ImGui::CalcTextSize(label.c_str()).x + 2 * ImGui::GetStyle().FramePadding.x;
}

float tabsWidth() {
    float width = 0;
    for (const Tab& tab : kTabs)
        width += buttonWidth(tab.label) + 1;
    return width;
}

/// What of a band's first row stands in it, at a width; the rest follows below.
struct FirstRow {
    float controls = 0;      ///< width of arrows and place
    bool hasTabs = true;     ///< else they are a row of their own, the first
    bool hasTitle = true;    ///< else it is wrapped below
    bool hasLeave = true;
};

FirstRow firstRow(const WindowState& ui, const std::vector<StoryPage>& pages, float width, const Theme& theme) {
    const ImGuiStyle& style = ImGui::GetStyle();
    FirstRow row;
    float title = 0, place = 0;
    for (const StoryPage& page : pages) {
        title = std::max(title, theme.heading->CalcTextSizeA(theme.headingSize, FLT_MAX, 0, page.title.c_str()).x);
        place = std::max(place, ImGui::CalcTextSize(page.place.c_str()).x);
    }
    const float gap = style.ItemSpacing.x;
    row.controls = 2 * ImGui::GetFrameHeight() + place + 3 * gap;
    const float leave = buttonWidth(leaveLabel(ui)) + gap;
    row.hasTabs = row.controls + tabsWidth() + 2 * gap + leave <= width;
    const float taken = row.controls + leave + (row.hasTabs ? tabsWidth() + 2 * gap : 0);
    row.hasLeave = row.hasTabs || row.controls + leave <= width;
    row.hasTitle = taken + title + 2 * gap <= width;
    return row;
}

bool hasColumns(const std::vector<StoryPage>& pages, float width, const Theme& theme) {
    return width >= kLeastForColumnsEm * theme.em &&
           std::ranges::any_of(pages, [](const StoryPage& page) { return !page.code.empty(); });
}

float heightOf(const StoryLine& line, float width, const Theme& theme) {
    const float spacing = ImGui::GetStyle().ItemSpacing.y;
    switch (line.kind) {
    case StoryLine::Kind::large: return wrappedHeight(theme.heading, theme.headingSize, line.text, width) + spacing;
    case StoryLine::Kind::key: return theme.em + spacing;
    default: return wrappedHeight(theme.text, theme.em, line.text, width) + spacing;
    }
}

/// Between lines of pseudocode, in pixels: they belong together.
float codeGap(const Theme& theme) { return std::round(0.15f * theme.em); }

float codeHeight(const StoryPage& page, float width, const Theme& theme) {
    float height = 0;
    for (const CodeLine& line : page.code)
        height += wrappedHeight(theme.code, theme.codeSize, line.text.empty() ? " " : line.text, width) + codeGap(theme);
    return height;
}

/// Pixels that the band would need at that width.
float bandHeight(const WindowState& ui, float windowWidth, const Theme& theme) {
    const ImGuiStyle& style = ImGui::GetStyle();
    const float row = ImGui::GetFrameHeight() + style.ItemSpacing.y;
    const float rim = 2 * style.WindowPadding.y;
    const float width = std::max(theme.em, windowWidth - 2 * style.WindowPadding.x);
    if (storyMode(ui) == StoryMode::explore)
        return tabsWidth() <= width ? ImGui::GetFrameHeight() + style.WindowPadding.y : 0; // a thin one
    const std::vector<StoryPage> pages = pagesOf(ui);
    const FirstRow first = firstRow(ui, pages, width, theme);
    const bool columns = hasColumns(pages, width, theme);
    const float textWidth = columns ? kTextShare * width : width;
    float highest = 0;
    for (const StoryPage& page : pages) {
        float height = 0;
        if (!first.hasTitle) height += wrappedHeight(theme.heading, theme.headingSize, page.title, width) + style.ItemSpacing.y;
        float text = 0;
        for (const StoryLine& line : page.lines)
            text += heightOf(line, textWidth, theme);
        const float code = codeHeight(page, columns ? width - textWidth - theme.em : width, theme);
        highest = std::max(highest, height + (columns ? std::max(text, code) : text + code));
    }
    return std::ceil(rim + row * (first.hasTabs ? 1.0f : 2.0f) + highest + style.ItemSpacing.y);
}

/// The modes, side by side. Lessons and slides are chosen from a menu.
void tabs(WindowState& ui) {
    const StoryMode mode = storyMode(ui);
    for (const Tab& tab : kTabs) {
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

void drawLine(WindowState& ui, const StoryLine& line, int choice, const Theme& theme) {
    const ImVec4 accent = ImGui::ColorConvertU32ToFloat4(kAccent);
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

/// Arrows, place, title, tabs, the way out. Returns which arrow was clicked: -1, 1, or 0.
int drawFirstRow(WindowState& ui, const StoryPage& page, const FirstRow& row, float width, const Theme& theme) {
    const ImGuiStyle& style = ImGui::GetStyle();
    const std::string leave = leaveLabel(ui);
    int by = 0;
    if (!row.hasTabs) tabs(ui);
    if (ImGui::ArrowButton("back", ImGuiDir_Left)) by = -1;
    hint("the one before (PageUp)");
    ImGui::SameLine();
    ImGui::TextColored(ImGui::ColorConvertU32ToFloat4(kAccent), "%s", page.place.c_str());
    ImGui::SameLine(style.WindowPadding.x + row.controls - ImGui::GetFrameHeight() - style.ItemSpacing.x);
    if (ImGui::ArrowButton("on", ImGuiDir_Right)) by = 1;
    hint("the next one (PageDown)");
    if (row.hasTitle) {
        ImGui::SameLine(style.WindowPadding.x + row.controls);
        ImGui::PushFont(theme.heading);
        ImGui::TextUnformatted(page.title.c_str());
        ImGui::PopFont();
    }
    const float right = style.WindowPadding.x + width;
    if (row.hasTabs) {
        ImGui::SameLine(right - buttonWidth(leave) - style.ItemSpacing.x - tabsWidth());
        tabs(ui);
    }
    if (row.hasLeave) {
        ImGui::SameLine(right - buttonWidth(leave));
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
    const float free = static_cast<float>(area.size.x) - 2 * style.WindowPadding.x - tabsWidth() - 2 * style.ItemSpacing.x;
    const float hintWidth = ImGui::CalcTextSize(kExploreHint).x;
    if (hintWidth <= free && storyMode(ui) == StoryMode::explore) {
        ImGui::SameLine(static_cast<float>(area.size.x) - style.WindowPadding.x - hintWidth);
        ImGui::AlignTextToFramePadding();
        ImGui::TextDisabled("%s", kExploreHint);
    }
    ImGui::End();
}

void drawBand(WindowState& ui, const Area& area, const Theme& theme) {
    const ImGuiStyle& style = ImGui::GetStyle();
    const std::vector<StoryPage> pages = pagesOf(ui);
    const StoryPage& page = pages.back();
    const float width = std::max(theme.em, static_cast<float>(area.size.x) - 2 * style.WindowPadding.x);
    const FirstRow row = firstRow(ui, pages, width, theme);
    beginIn("story", area, ImGuiWindowFlags_NoNav);
    const float free = ImGui::GetContentRegionAvail().x; // without a scrollbar's width
    const int by = drawFirstRow(ui, page, row, free, theme);
    if (!row.hasTitle) {
        ImGui::PushFont(theme.heading);
        ImGui::TextWrapped("%s", page.title.c_str());
        ImGui::PopFont();
    }
    const bool columns = hasColumns(pages, width, theme);
    const float textWidth = columns ? kTextShare * free : free;
    const ImVec2 top = ImGui::GetCursorPos();
    ImGui::PushTextWrapPos(style.WindowPadding.x + textWidth);
    int choice = 0;
    for (const StoryLine& line : page.lines) {
        drawLine(ui, line, choice, theme);
        if (line.kind == StoryLine::Kind::choice) ++choice;
    }
    ImGui::PopTextWrapPos();
    if (columns) ImGui::SetCursorPos({style.WindowPadding.x + textWidth + theme.em, top.y});
    ImGui::BeginGroup();
    drawCode(page, theme);
    ImGui::EndGroup();
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

StoryLayout layStory(const WindowState& ui, const Area& room, const Theme& theme) {
    StoryLayout layout{room, room, {room.corner, ivec2(0)}, {room.corner, ivec2(0)}};
    if (room.size.x < 1 || room.size.y < 1) return layout;
    const SlideFigureKind kind = slideFigureKind(ui);
    const ivec2 end = room.corner + room.size;
    if (kind == SlideFigureKind::ofPixel) {
        // The picture has the shape that slides are made for: so a pixel of the slide is the same place in it.
        const int left = static_cast<int>(kPictureShare * static_cast<float>(room.size.x));
        const int height = std::min(static_cast<int>(std::lround(left / course::kLessonAspect)), room.size.y);
        layout.pictures = {room.corner, {left, height}};
        layout.band = {room.corner + ivec2(0, height), {left, room.size.y - height}};
        layout.figure = {room.corner + ivec2(left, 0), {room.size.x - left, room.size.y}};
        return layout;
    }
    const auto most = static_cast<float>(room.size.y) * kMostOfRoom;
    const float needed = bandHeight(ui, static_cast<float>(room.size.x), theme);
    const bool isLeftOut =
        storyMode(ui) == StoryMode::explore && static_cast<float>(room.size.y) < kLeastRoomEm * theme.em;
    const int height = isLeftOut ? 0 : static_cast<int>(std::min(needed, most));
    layout.pictures.size.y -= height;
    layout.band = {{room.corner.x, end.y - height}, {room.size.x, height}};
    if (kind == SlideFigureKind::wholeSlide) layout.figure = layout.pictures;
    return layout;
}

void storyBar(WindowState& ui, const SlideFigure& figure, const StoryLayout& layout, const Theme& theme) {
    if (layout.figure.size.x > 0 && layout.figure.size.y > 0) drawFigure(figure, layout.figure);
    if (layout.band.size.x < 1 || layout.band.size.y < 1) return;
    if (storyMode(ui) == StoryMode::explore)
        drawThinBand(ui, layout.band);
    else
        drawBand(ui, layout.band, theme);
}

} // namespace shadowlab::window
