// SPDX-License-Identifier: MIT
#include "app/course/slides/slide_layout.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace shadowlab::course {

namespace {

constexpr double kGap = 28;          ///< between parts
constexpr double kWordsShare = 0.36; ///< of the width, beside pictures
// The shapes that scenes are framed for: from two panes side by side to a whole screen.
constexpr double kWidestPicture = 16.0 / 9, kNarrowestPicture = 1.2;
constexpr double kNarrowestDrawing = 0.9; ///< what is narrower has no room for its labels
constexpr double kWidestUseful = 2;       ///< a drawing in a wider field has empty sides: what it shows follows the height
constexpr double kLeastHeight = 40;       ///< of a picture; lower ones show nothing
constexpr double kNearlyAsLarge = 1.12;   ///< pictures in more rows may be so much smaller: they use the whole height of the slide

/// Rows of pictures, all equally high, with their widths.
struct Rows {
    std::size_t columns = 1;
    double height = 0; ///< of a picture
    std::vector<double> widths;
    std::vector<double> labels, legends; ///< heights, the same within a row
    [[nodiscard]] double shown() const {
        double area = 0;
        for (const double width : widths)
            area += std::min(width, kWidestUseful * height) * height;
        return area;
    }
};

double leastWidth(const PictureNeeds& picture, double height) {
    return height * picture.aspect.value_or(picture.isDrawing ? kNarrowestDrawing : kNarrowestPicture);
}
double mostWidth(const PictureNeeds& picture, double height) {
    if (picture.aspect) return height * *picture.aspect;
    return picture.isDrawing ? std::numeric_limits<double>::infinity() : height * kWidestPicture;
}

/// Of a row's pictures the widths that are nearest to one another and fill the room, as far as their shapes allow. Empty: they do not fit.
std::vector<double> widthsOf(std::span<const PictureNeeds> row, double height, double room) {
    const auto widthsFor = [&](double common) {
        std::vector<double> widths;
        for (const PictureNeeds& picture : row)
            widths.push_back(std::clamp(common, leastWidth(picture, height), mostWidth(picture, height)));
        return widths;
    };
    const auto sum = [&](double common) {
        double width = kGap * static_cast<double>(row.size() - 1);
        for (const double one : widthsFor(common))
            width += one;
        return width;
    };
    if (sum(0) > room) return {};
    double low = 0, high = room;
    constexpr int kHalvings = 50; // to far below a pixel
    for (int i = 0; i < kHalvings; ++i)
        (sum(0.5 * (low + high)) <= room ? low : high) = 0.5 * (low + high);
    return widthsFor(low);
}

/// All pictures in so many columns, each of that height; false where they do not fit.
bool place(Rows& rows, std::span<const PictureNeeds> needs, double height, dvec2 room, const Fonts& fonts) {
    rows.height = height;
    rows.widths.clear();
    rows.labels.clear();
    rows.legends.clear();
    double total = 0;
    for (std::size_t first = 0; first < needs.size(); first += rows.columns) {
        const std::span<const PictureNeeds> row = needs.subspan(first, std::min(rows.columns, needs.size() - first));
        std::vector<double> widths = widthsOf(row, height, room.x);
        if (widths.empty()) return false;
        // Below one another pictures that may be of any width are as wide as the narrowest of them.
        if (first > 0)
            for (std::size_t i = 0; i < row.size(); ++i)
                widths[i] = std::clamp(rows.widths[i], leastWidth(row[i], height), std::min(mostWidth(row[i], height), widths[i]));
        double label = 0, legend = 0;
        for (std::size_t i = 0; i < row.size(); ++i) {
            const auto lines = drawing::wrapProse(row[i].label, kLabelType, widths[i], true, fonts.formula());
            if (!row[i].label.empty()) label = std::max(label, kLineHeight * kLabelType * static_cast<double>(lines.size()));
            if (row[i].legendHeight) legend = std::max(legend, row[i].legendHeight(widths[i]));
        }
        rows.labels.insert(rows.labels.end(), row.size(), label);
        rows.widths.insert(rows.widths.end(), widths.begin(), widths.end());
        rows.legends.insert(rows.legends.end(), row.size(), legend);
        total += (first > 0 ? kGap : 0) + label + height + legend;
    }
    return total <= room.y;
}

/// The highest pictures that fit in so many columns.
Rows highest(std::span<const PictureNeeds> needs, std::size_t columns, dvec2 room, const Fonts& fonts) {
    Rows rows{columns, 0, {}, {}, {}};
    double low = kLeastHeight, high = room.y;
    constexpr int kHalvings = 40;
    for (int i = 0; i < kHalvings; ++i) {
        const double middle = 0.5 * (low + high);
        (place(rows, needs, middle, room, fonts) ? low : high) = middle;
    }
    place(rows, needs, std::floor(low), room, fonts);
    return rows;
}

Rows largest(std::span<const PictureNeeds> needs, dvec2 room, const Fonts& fonts) {
    Rows best;
    for (std::size_t columns = needs.size(); columns >= 1; --columns) {
        const Rows rows = highest(needs, columns, room, fonts);
        const bool isPrime = needs.size() == 5 || needs.size() == 7;       // more than a row of them has a last row with gaps
        if (needs.size() % columns != 0 && !isPrime) continue;
        if (best.widths.empty() || kNearlyAsLarge * rows.shown() > best.shown()) best = rows;
    }
    return best;
}

void placePictures(SlideLayout& layout, const Box& area, std::span<const PictureNeeds> needs, const Fonts& fonts) {
    const bool isLabelled = std::ranges::any_of(needs, [](const PictureNeeds& one) { return !one.label.empty(); });
    const Rows rows = largest(needs, area.size, fonts);
    dvec2 at = area.corner;
    double right = at.x, bottom = at.y;
    for (std::size_t i = 0; i < needs.size(); ++i) {
        if (i > 0 && i % rows.columns == 0) at = {area.corner.x, bottom + kGap};
        const dvec2 size(rows.widths[i], rows.height);
        const double label = rows.labels[i];
        if (isLabelled) layout.labels.push_back({at, {size.x, label}});
        layout.cells.push_back({at + dvec2(0, label), size});
        layout.legends.push_back({at + dvec2(0, label + size.y), {size.x, rows.legends[i]}});
        right = std::max(right, at.x + size.x);
        bottom = std::max(bottom, at.y + label + size.y + rows.legends[i]);
        at.x += size.x + kGap;
    }
    layout.pictures = {area.corner, dvec2(right, bottom) - area.corner};
}

} // namespace

SlideLayout layOut(const Slide& slide, double width, const Fonts& fonts, std::span<const PictureNeeds> needs) {
    SlideLayout layout;
    layout.width = width;
    const double room = width - 2 * kMargin;
    layout.title = drawing::wrapProse(slide.written.title, kTitleType, room, true, fonts.formula());
    if (!slide.written.caption.empty())
        layout.caption = drawing::wrapProse(slide.written.caption, kCaptionType, room, false, fonts.formula());
    const double top = kMargin / 2 + kLineHeight * kTitleType * static_cast<double>(layout.title.size()) + kGap / 2;
    const double captionHeight = kLineHeight * kCaptionType * static_cast<double>(layout.caption.size());
    const double bottom = kSlideHeight - 2 * kLineHeight * kFootType - captionHeight;
    layout.content = {{kMargin, top}, {room, bottom - top}};
    layout.captionTop = bottom + 0.1 * kCaptionType;
    const bool hasWords = !slide.text.empty() || !slide.formulas.empty() || !slide.pseudocode.empty();
    if (hasWords) layout.words = layout.content;
    if (needs.empty()) return layout;
    Box area = layout.content;
    if (hasWords) area.size.x -= kWordsShare * area.size.x + kGap;
    placePictures(layout, area, needs, fonts);
    if (hasWords) { // all that pictures of their own shape leave free
        layout.words.corner.x = layout.pictures.corner.x + layout.pictures.size.x + kGap;
        layout.words.size.x = kMargin + room - layout.words.corner.x;
    } else { // a caption belongs to what it is about
        layout.content.size.y = layout.pictures.size.y;
        layout.captionTop += layout.content.corner.y + layout.content.size.y - bottom;
    }
    return layout;
}

} // namespace shadowlab::course
