// SPDX-License-Identifier: MIT
#include "app/course/slides/slide_layout.h"

#include <algorithm>
#include <cmath>

namespace shadowlab::course {

namespace {

constexpr double kGap = 28;           ///< between parts
constexpr double kWordsShare = 0.36;  ///< of the width, beside pictures
constexpr double kLegendHeight = 180; ///< of a key of eight colours in two columns, some of two lines
constexpr double kWidestPicture = 16.0 / 9, kNarrowestPicture = 4.0 / 3; ///< the shapes that scenes are framed for

/// Rows and columns for so many pictures.
int columnsFor(std::size_t pictures) {
    if (pictures <= 3) return static_cast<int>(pictures);
    if (pictures == 4) return 2;
    return pictures <= 6 ? 3 : 4;
}

/// Stages explain their colours.
bool mayHaveLegend(const SlidePicture& picture) {
    return std::ranges::any_of(picture.state.slots, [](const lab::PaneState& slot) { return !slot.stage.isPicture(); });
}

/// The part of a cell that a picture takes: as large as its shape allows, at its top. Below it there is room for a legend, as
/// far as that makes it no wider than scenes are framed for.
Box pictureIn(const Box& cell, bool hasLegend) {
    Box box = cell;
    if (hasLegend)
        box.size.y = std::min(cell.size.y, std::max(cell.size.y - kLegendHeight, cell.size.x / kWidestPicture));
    const double aspect = box.size.x / box.size.y;
    if (aspect > kWidestPicture) box.size.x = box.size.y * kWidestPicture;
    if (aspect < kNarrowestPicture) box.size.y = box.size.x / kNarrowestPicture;
    box.corner.x += (cell.size.x - box.size.x) / 2.0;
    return box;
}

} // namespace

SlideLayout layOut(const Slide& slide, double width, const Fonts& fonts) {
    SlideLayout layout;
    layout.width = width;
    const int room = static_cast<int>(width - 2 * kMargin);
    layout.title = fonts.bold.wrap(slide.title, kTitleType, room);
    if (!slide.caption.empty()) layout.caption = fonts.upright.wrap(slide.caption, kCaptionType, room);
    const double top = kMargin / 2 + kLineHeight * kTitleType * static_cast<double>(layout.title.size()) + kGap / 2;
    const double bottom = kSlideHeight - 2 * kLineHeight * kFootType -
                          kLineHeight * kCaptionType * static_cast<double>(layout.caption.size());
    Box area{{kMargin, top}, {width - 2 * kMargin, bottom - top}};
    layout.content = area;
    const bool hasWords = !slide.text.empty() || !slide.formulas.empty() || !slide.pseudocode.empty();
    if (slide.pictures.empty()) {
        layout.words = area;
        return layout;
    }
    if (hasWords) {
        layout.words = area;
        layout.words.size.x = kWordsShare * area.size.x;
        layout.words.corner.x = area.corner.x + area.size.x - layout.words.size.x;
        area.size.x -= layout.words.size.x + kGap;
    }
    const bool isDrawing = slide.pictures.size() == 1 && !slide.pictures[0].figure.empty();
    if (isDrawing && !hasWords) area = {{0, top}, {width, bottom - top}}; // it has a border of its own
    layout.pictures = area;
    const int columns = columnsFor(slide.pictures.size());
    const int rows = (static_cast<int>(slide.pictures.size()) + columns - 1) / columns;
    const bool labelled = std::ranges::any_of(slide.pictures, [](const auto& p) { return !p.label.empty(); });
    const double label = labelled ? kLineHeight * kLabelType : 0;
    const bool hasLegends = std::ranges::any_of(slide.pictures, mayHaveLegend);
    const dvec2 cell((area.size.x - kGap * (columns - 1)) / columns, (area.size.y - kGap * (rows - 1)) / rows);
    for (std::size_t i = 0; i < slide.pictures.size(); ++i) {
        const dvec2 place(static_cast<int>(i) % columns, static_cast<int>(i) / columns);
        const Box whole{area.corner + place * (cell + kGap) + dvec2(0, label), cell - dvec2(0, label)};
        layout.cells.push_back(slide.pictures[i].figure.empty() ? pictureIn(whole, hasLegends) : whole);
        layout.roomBelow.push_back(whole.size.y - layout.cells.back().size.y);
    }
    return layout;
}

} // namespace shadowlab::course
