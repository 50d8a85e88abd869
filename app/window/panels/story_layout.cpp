// SPDX-License-Identifier: MIT
#include "app/window/panels/story_layout.h"

#include <algorithm>
#include <cmath>

#include "app/course/lessons/lesson.h"
#include "app/window/panels/prose_text.h"
#include "app/window/panels/widgets.h"
#include "app/window/slide_figure.h"

namespace shadowlab::window {

namespace {

constexpr float kMostOfRoom = 0.45f;    ///< of the height: longer texts scroll, and the pictures keep the larger part
constexpr float kLeastRoomEm = 16;      ///< height below which a band that tells nothing is left out
constexpr float kLeastForColumnsEm = 34; ///< width below which pseudocode stands below the text and not beside it
constexpr float kPictureShare = 0.42f;  ///< of the width, beside a drawing; its type has to be read as well

constexpr float kLeastTextShare = 0.35f, kMostTextShare = 0.65f; ///< of the width, for text beside pseudocode

StoryPage pageOf(const WindowState& ui) {
    switch (storyMode(ui)) {
    case StoryMode::steps: return stepPage(ui);
    case StoryMode::lesson: return lessonPage(ui);
    case StoryMode::slides: return slidePage(ui);
    case StoryMode::explore: break;
    }
    return {};
}

float heightOf(const StoryLine& line, float width, const Theme& theme) {
    const float spacing = ImGui::GetStyle().ItemSpacing.y;
    if (!line.written.empty()) return proseHeight(line.written, width, theme) + spacing;
    switch (line.kind) {
    case StoryLine::Kind::large: return wrappedHeight(theme.heading, theme.headingSize, line.text, width) + spacing;
    case StoryLine::Kind::key: return theme.em + spacing;
    default: return wrappedHeight(theme.text, theme.em, line.text, width) + spacing;
    }
}

float codeHeight(const StoryPage& page, float width, const Theme& theme) {
    float height = 0;
    for (const CodeLine& line : page.code)
        height += wrappedHeight(theme.code, theme.codeSize, line.text.empty() ? " " : line.text, width) + codeGap(theme);
    return height;
}

/// Height of a page's text and pseudocode, where the text has that share of the width: beside one another, or one below the other.
float pageHeight(const StoryPage& page, float width, float textShare, const Theme& theme) {
    const bool hasColumns = textShare < 1;
    float text = 0;
    for (const StoryLine& line : page.lines)
        text += heightOf(line, textShare * width, theme);
    const float code = codeHeight(page, hasColumns ? (1 - textShare) * width - theme.em : width, theme);
    return hasColumns ? std::max(text, code) : text + code;
}

/// Half of the width, or what the longest line of pseudocode leaves: with which of them the highest page is lower.
float bestTextShare(const std::vector<StoryPage>& pages, float width, const Theme& theme) {
    float longest = 0, halved = 0, fitted = 0;
    for (const StoryPage& page : pages)
        for (const CodeLine& line : page.code)
            longest = std::max(longest, theme.code->CalcTextSizeA(theme.codeSize, FLT_MAX, 0, line.text.c_str()).x);
    const float left = std::clamp(1 - (longest + 2 * theme.em) / width, kLeastTextShare, kMostTextShare);
    for (const StoryPage& page : pages) {
        halved = std::max(halved, pageHeight(page, width, 0.5f, theme));
        fitted = std::max(fitted, pageHeight(page, width, left, theme));
    }
    return fitted < halved ? left : 0.5f;
}

/// Pixels that the band would need at that width.
float bandHeight(const WindowState& ui, float windowWidth, const Theme& theme) {
    const ImGuiStyle& style = ImGui::GetStyle();
    const float row = ImGui::GetFrameHeight() + style.ItemSpacing.y;
    const float rim = 2 * style.WindowPadding.y;
    const float width = std::max(theme.em, windowWidth - 2 * style.WindowPadding.x);
    if (storyMode(ui) == StoryMode::explore)
        return storyTabsWidth() <= width ? ImGui::GetFrameHeight() + style.WindowPadding.y : 0; // a thin one
    const std::vector<StoryPage> pages = pagesOfBand(ui);
    const BandShape shape = bandShape(ui, pages, width, theme);
    float highest = 0;
    for (const StoryPage& page : pages) {
        float height = 0;
        if (!shape.hasTitle) height += wrappedHeight(theme.heading, theme.headingSize, page.title, width) + style.ItemSpacing.y;
        highest = std::max(highest, height + pageHeight(page, width, shape.textShare, theme));
    }
    return std::ceil(rim + row * (shape.hasTabs ? 1.0f : 2.0f) + highest + style.ItemSpacing.y);
}

} // namespace

float storyButtonWidth(const std::string& label) {
    return ImGui::CalcTextSize(label.c_str()).x + 2 * ImGui::GetStyle().FramePadding.x;
}

float storyTabsWidth() {
    float width = 0;
    for (const StoryTab& tab : kStoryTabs)
        width += storyButtonWidth(tab.label) + 1;
    return width;
}

std::string leaveLabel(const WindowState& ui) {
    switch (outerMode(ui)) {
    case StoryMode::lesson: return "Esc: to the lesson";
    case StoryMode::slides: return "Esc: to the slide";
    default: return "Esc: leave";
    }
}

std::vector<StoryPage> pagesOfBand(const WindowState& ui) {
    std::vector<StoryPage> pages;
    if (storyMode(ui) == StoryMode::steps) pages = stepPages(ui);
    if (storyMode(ui) == StoryMode::lesson) pages = lessonPages(ui);
    pages.push_back(pageOf(ui));
    // A slide's four pictures, its text and the strip do not all fit: while stages are chosen, the text makes room.
    if (storyMode(ui) == StoryMode::slides && ui.shown.strip)
        for (StoryPage& page : pages)
            page.lines.clear();
    return pages;
}

BandShape bandShape(const WindowState& ui, const std::vector<StoryPage>& pages, float width, const Theme& theme) {
    const ImGuiStyle& style = ImGui::GetStyle();
    BandShape row;
    float title = 0, place = 0;
    for (const StoryPage& page : pages) {
        title = std::max(title, theme.heading->CalcTextSizeA(theme.headingSize, FLT_MAX, 0, page.title.c_str()).x);
        place = std::max(place, ImGui::CalcTextSize(page.place.c_str()).x);
    }
    const float gap = style.ItemSpacing.x;
    row.controls = 2 * ImGui::GetFrameHeight() + place + 3 * gap;
    const float leave = storyButtonWidth(leaveLabel(ui)) + gap;
    row.hasTabs = row.controls + storyTabsWidth() + 2 * gap + leave <= width;
    const float taken = row.controls + leave + (row.hasTabs ? storyTabsWidth() + 2 * gap : 0);
    row.hasLeave = row.hasTabs || row.controls + leave <= width;
    row.hasTitle = taken + title + 2 * gap <= width;
    row.hasColumns = width >= kLeastForColumnsEm * theme.em &&
                     std::ranges::any_of(pages, [](const StoryPage& page) { return !page.code.empty(); });
    if (row.hasColumns) row.textShare = bestTextShare(pages, width, theme);
    return row;
}

float codeGap(const Theme& theme) { return std::round(0.15f * theme.em); }

StoryLayout layStory(const WindowState& ui, const Area& room, const LegendLines& legends, const Theme& theme) {
    StoryLayout layout{room, room, {room.corner, ivec2(0)}, {room.corner, ivec2(0)}, false};
    if (room.size.x < 1 || room.size.y < 1) return layout;
    const SlideFigureKind kind = slideFigureKind(ui);
    const ivec2 end = room.corner + room.size;
    if (kind == SlideFigureKind::ofPixel) {
        // The picture has the shape that slides are made for: so a pixel of the slide is the same place in it.
        const int left = static_cast<int>(kPictureShare * static_cast<float>(room.size.x));
        const auto pictureHeight = static_cast<int>(std::lround(left / course::kLessonAspect));
        const int height = std::min(pictureHeight + compactBands(theme, pictureHeight, legends), room.size.y);
        layout.hasCompactHeader = true;
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

} // namespace shadowlab::window
