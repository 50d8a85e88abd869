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

constexpr float kMostOfRoom = 0.45f;     ///< of the height, for the band: longer texts are set smaller,
constexpr float kLeastPictures = 0.43f;  ///< so that the pictures without their own bands keep that share of it
constexpr float kLeastRoomEm = 16;      ///< height below which a band that tells nothing is left out
constexpr float kLeastForColumnsEm = 34; ///< width below which pseudocode stands below the text and not beside it
constexpr float kPictureShare = 0.42f;  ///< of the width, beside a drawing; its type has to be read as well
constexpr float kLeastBesideDrawing = 0.6f; ///< of such a picture's height, where the text below it is long

constexpr float kLeastTextShare = 0.25f, kMostTextShare = 0.65f; ///< of the width, for text beside pseudocode

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

float titleHeight(const StoryPage& page, float width, const Theme& theme) {
    return page.writtenTitle.empty() ? wrappedHeight(theme.heading, theme.headingSize, page.title, width)
                                     : proseHeight(page.writtenTitle, width, forHeading(theme));
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

/// Half of the width, what the longest line of pseudocode leaves, or the least: with which of them the highest page is lowest.
float bestTextShare(const std::vector<StoryPage>& pages, float width, const Theme& theme) {
    float longest = 0;
    for (const StoryPage& page : pages)
        for (const CodeLine& line : page.code)
            longest = std::max(longest, theme.code->CalcTextSizeA(theme.codeSize, FLT_MAX, 0, line.text.c_str()).x);
    const float left = std::clamp(1 - (longest + 2 * theme.em) / width, kLeastTextShare, kMostTextShare);
    float best = 0.5f, lowest = FLT_MAX;
    for (const float share : {0.5f, left, kLeastTextShare}) {
        float highest = 0;
        for (const StoryPage& page : pages)
            highest = std::max(highest, pageHeight(page, width, share, theme));
        if (highest >= lowest) continue;
        best = share;
        lowest = highest;
    }
    return best;
}

/// Pixels that the band needs at that width, with its text in that share of the type's size.
float bandHeight(const WindowState& ui, float windowWidth, float typeShare, const Theme& theme) {
    const ImGuiStyle& style = ImGui::GetStyle();
    const float row = ImGui::GetFrameHeight() + style.ItemSpacing.y;
    const float rim = 2 * style.WindowPadding.y;
    const float width = std::max(theme.em, windowWidth - 2 * style.WindowPadding.x);
    if (storyMode(ui) == StoryMode::explore)
        return storyTabsWidth() <= width ? ImGui::GetFrameHeight() + style.WindowPadding.y : 0; // a thin one
    const std::vector<StoryPage> pages = pagesOfBand(ui);
    const BandShape shape = bandShape(ui, pages, width, typeShare, theme);
    const Theme smaller = withType(theme, typeShare);
    float highest = 0;
    for (const StoryPage& page : pages) {
        float height = 0;
        if (shape.hasTitle) // beside the buttons
            height += std::max(0.0f, titleHeight(page, width, theme) - ImGui::GetFrameHeight());
        else
            height += titleHeight(page, width, smaller) + style.ItemSpacing.y;
        highest = std::max(highest, height + pageHeight(page, width, shape.textShare, smaller));
    }
    return std::ceil(rim + row * (shape.hasTabs ? 1.0f : 2.0f) + highest + style.ItemSpacing.y);
}

/// The height of the band and the type of its text: the largest with which it takes no more than `most` pixels. A text that is too long
/// for the smallest scrolls.
struct FittedBand {
    int height = 0;
    float typeShare = 1;
};
FittedBand fitBand(const WindowState& ui, float width, float most, const Theme& theme) {
    if (const float height = bandHeight(ui, width, 1, theme); height <= most) return {static_cast<int>(height), 1};
    FittedBand fitted{static_cast<int>(most), kSmallestType};
    // By halves, as texts take time to be set: `fits` steps smaller is enough, or the smallest.
    int tooLarge = 0, fits = static_cast<int>(std::lround((1 - kSmallestType) / kTypeStep)) + 1;
    while (fits - tooLarge > 1) {
        const int steps = (tooLarge + fits) / 2;
        const float share = 1 - static_cast<float>(steps) * kTypeStep, height = bandHeight(ui, width, share, theme);
        (height <= most ? fits : tooLarge) = steps;
        if (height <= most) fitted = {static_cast<int>(height), share};
    }
    return fitted;
}

/// Left the picture and the text, right the drawing. The picture has the shape that slides are made for, or is lower where the text needs
/// the room: then more is seen at its sides, and a pixel of the slide is the same place in the scene.
StoryLayout besideDrawing(const WindowState& ui, StoryLayout layout, const LegendLines& legends, const Theme& theme) {
    const Area& room = layout.room;
    const int left = static_cast<int>(kPictureShare * static_cast<float>(room.size.x));
    const auto wanted = static_cast<int>(std::lround(left / course::kLessonAspect));
    const auto least = static_cast<int>(kLeastBesideDrawing * static_cast<float>(wanted));
    const int bands = compactBands(theme, wanted, legends);
    const int most = std::max(0, room.size.y - least - bands);
    const FittedBand band = fitBand(ui, static_cast<float>(left), static_cast<float>(most), theme);
    const int height = std::clamp(std::min(wanted + bands, room.size.y - band.height), 0, room.size.y);
    layout.hasCompactHeader = true;
    layout.typeShare = band.typeShare;
    layout.pictures = {room.corner, {left, height}};
    layout.band = {room.corner + ivec2(0, height), {left, room.size.y - height}};
    layout.figure = {room.corner + ivec2(left, 0), {room.size.x - left, room.size.y}};
    return layout;
}

/// What the band may take: the panes keep their own bands, with headers and legends, and the larger part of the rest.
float mostOfBand(const WindowState& ui, const Area& room, const LegendLines& legends, const Theme& theme) {
    const auto height = static_cast<float>(room.size.y);
    const Area panes{room.corner, {room.size.x, static_cast<int>((1 - kMostOfRoom) * height)}};
    const int ownBands = panes.size.y - paneFrames(ui, theme, panes, legends, false).pictureSize().y;
    return std::min(kMostOfRoom * height, std::max(0.0f, (1 - kLeastPictures) * height - static_cast<float>(ownBands)));
}

} // namespace

float titleWidth(const StoryPage& page, const Theme& theme) {
    return page.writtenTitle.empty() ? theme.heading->CalcTextSizeA(theme.headingSize, FLT_MAX, 0, page.title.c_str()).x
                                     : proseWidth(page.writtenTitle, forHeading(theme));
}

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

BandShape bandShape(const WindowState& ui, const std::vector<StoryPage>& pages, float width, float typeShare, const Theme& theme) {
    const ImGuiStyle& style = ImGui::GetStyle();
    const Theme smaller = withType(theme, typeShare);
    BandShape row;
    float title = 0, place = 0;
    for (const StoryPage& page : pages) {
        title = std::max(title, titleWidth(page, theme));
        place = std::max(place, ImGui::CalcTextSize(page.place.c_str()).x);
    }
    const float gap = style.ItemSpacing.x;
    row.controls = 2 * ImGui::GetFrameHeight() + place + 3 * gap;
    if (row.controls > width && !pages.back().shortPlace.empty()) {
        row.hasShortPlace = true;
        row.controls -= place - ImGui::CalcTextSize(pages.back().shortPlace.c_str()).x;
    }
    const float leave = storyButtonWidth(leaveLabel(ui)) + gap;
    row.hasTabs = row.controls + storyTabsWidth() + 2 * gap + leave <= width;
    const float taken = row.controls + leave + (row.hasTabs ? storyTabsWidth() + 2 * gap : 0);
    row.hasLeave = row.hasTabs || row.controls + leave <= width;
    row.hasTitle = taken + title + 2 * gap <= width;
    row.hasColumns = width >= kLeastForColumnsEm * smaller.em &&
                     std::ranges::any_of(pages, [](const StoryPage& page) { return !page.code.empty(); }) &&
                     std::ranges::any_of(pages, [](const StoryPage& page) { return !page.lines.empty(); });
    if (row.hasColumns) row.textShare = bestTextShare(pages, width, smaller);
    return row;
}

float codeGap(const Theme& theme) { return std::round(0.15f * theme.em); }

StoryLayout layStory(const WindowState& ui, const Area& room, const LegendLines& legends, const Theme& theme) {
    StoryLayout layout{room, room, {room.corner, ivec2(0)}, {room.corner, ivec2(0)}};
    if (room.size.x < 1 || room.size.y < 1) return layout;
    const SlideFigureKind kind = slideFigureKind(ui);
    if (kind == SlideFigureKind::ofPixel) return besideDrawing(ui, layout, legends, theme);
    const ivec2 end = room.corner + room.size;
    const bool isLeftOut =
        storyMode(ui) == StoryMode::explore && static_cast<float>(room.size.y) < kLeastRoomEm * theme.em;
    const FittedBand band = isLeftOut ? FittedBand{}
                                      : fitBand(ui, static_cast<float>(room.size.x), mostOfBand(ui, room, legends, theme), theme);
    const int height = band.height;
    layout.typeShare = band.typeShare;
    layout.pictures.size.y -= height;
    layout.band = {{room.corner.x, end.y - height}, {room.size.x, height}};
    if (kind == SlideFigureKind::wholeSlide) layout.figure = layout.pictures;
    return layout;
}

} // namespace shadowlab::window
