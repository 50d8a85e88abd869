// SPDX-License-Identifier: MIT
#include "app/course/slides/slide_layout.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "app/course/slides/slide_words.h"

namespace shadowlab::course {

namespace {

constexpr double kGap = 28;          ///< between parts
// Of the width, beside pictures: at most, at least, and the steps between. In less than the least lines have but two or three words.
constexpr double kMostWords = 0.36, kLeastWords = 0.26, kWordsStep = 0.02;
// The shapes that scenes are framed for: from three panes side by side to a whole screen.
constexpr double kWidestPicture = 16.0 / 9, kNarrowestPicture = 1, kNarrowestOfMany = 1.2;
constexpr std::size_t kFew = 3; ///< pictures of a row that may be as narrow as that: more of them would be a low strip
constexpr double kNarrowestDrawing = 0.9; ///< what is narrower has no room for its labels
constexpr double kWidestUseful = 2;       ///< a drawing in a wider field has empty sides: what it shows follows the height
constexpr double kLeastHeight = 40;       ///< of a picture; lower ones show nothing
constexpr double kNearlyAsLarge = 1.12;   ///< pictures in more rows may be so much smaller: they use the whole height of the slide
constexpr double kFilled = 0.9; ///< of the width: pictures that fill less leave a side of the slide empty
constexpr double kWorthASide = 1.25; ///< pictures may be so much smaller where the caption fills that side

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
    /// Of the first row, which is the widest.
    [[nodiscard]] double width() const {
        double sum = 0;
        for (std::size_t i = 0; i < std::min(columns, widths.size()); ++i)
            sum += widths[i] + (i > 0 ? kGap : 0);
        return sum;
    }
};

double leastWidth(const PictureNeeds& picture, double height, std::size_t columns) {
    const double narrowest = picture.isDrawing ? kNarrowestDrawing : columns > kFew ? kNarrowestOfMany : kNarrowestPicture;
    return height * picture.aspect.value_or(narrowest);
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
            widths.push_back(std::clamp(common, leastWidth(picture, height, row.size()), mostWidth(picture, height)));
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
                widths[i] = std::clamp(rows.widths[i], leastWidth(row[i], height, row.size()), std::min(mostWidth(row[i], height), widths[i]));
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

void placePictures(SlideLayout& layout, const Box& area, const Rows& rows, std::span<const PictureNeeds> needs) {
    const bool isLabelled = std::ranges::any_of(needs, [](const PictureNeeds& one) { return !one.label.empty(); });
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

/// The narrowest column for words beside pictures, in units, in which their type, and that of their formulas, is as large as in the widest.
double wordsWidth(const Slide& slide, dvec2 room, const Fonts& fonts) {
    const auto type = [&](double share) { return wordsType(slide, false, {share * room.x, room.y}, fonts); };
    const WordsType widest = type(kMostWords);
    double least = kMostWords;
    for (double share = kMostWords - kWordsStep; share > kLeastWords - 0.5 * kWordsStep; share -= kWordsStep)
        if (type(share) == widest) least = share;
    return least * room.x;
}

/// The caption beside the pictures, if they are larger then than above it, or leave a side empty there; and if it is well read.
bool placeBesideCaption(SlideLayout& layout, const Slide& slide, const Box& content, const Rows& above, std::span<const PictureNeeds> needs,
                        const Fonts& fonts) {
    const dvec2 column(kLeastWords * content.size.x, content.size.y);
    if (wordsType(slide, true, column, fonts).letters < kCaptionType) return false;
    const Box area{content.corner, {content.size.x - column.x - kGap, content.size.y}};
    const Rows rows = largest(needs, area.size, fonts);
    const double worth = above.width() < kFilled * content.size.x ? kWorthASide : 1;
    if (worth * rows.shown() <= above.shown()) return false;
    layout.caption.clear();
    layout.hasCaptionBeside = true;
    layout.content = content;
    layout.captionTop = content.corner.y + content.size.y;
    placePictures(layout, area, rows, needs);
    return true;
}

/// One picture of any shape before three that have a shape of their own, which in one row would all be low; all of them with a label.
bool isOneBeforeThree(std::span<const PictureNeeds> needs) {
    return needs.size() == 4 && !needs[0].aspect && std::ranges::none_of(needs, [](const auto& one) { return one.label.empty(); }) &&
           std::ranges::all_of(needs.subspan(1), [](const auto& one) { return one.aspect.has_value(); });
}

/// The first picture large, as high as the two rows beside it, and the caption in the place that three pictures leave; false if it does
/// not fit there, or if the pictures were no larger for it.
bool placeFirstLarge(SlideLayout& layout, const Slide& slide, const Box& content, const Rows& inRows, std::span<const PictureNeeds> needs,
                     const Fonts& fonts) {
    if (!isOneBeforeThree(needs)) return false;
    const std::span<const PictureNeeds> small = needs.subspan(1);
    // The three take what is left of the width when the first has its least; they are as high as two rows of them can be.
    const dvec2 beside(0.5 * content.size.x, content.size.y);
    const Rows rows = highest(small, 2, beside, fonts);
    const double smallWidth = rows.width(), label = rows.labels.front();
    const double foot = label + rows.height + rows.legends.front() + kGap + rows.labels.back() + rows.height; // of the second row's picture
    const double height = foot - label, width = std::min(content.size.x - smallWidth - kGap, kWidestPicture * height);
    const double legend = needs.front().legendHeight ? needs.front().legendHeight(width) : 0;
    const dvec2 caption(rows.widths.front(), rows.height);
    const bool fits = width >= kNarrowestPicture * height && legend <= rows.legends.back();
    if (!fits || wordsType(slide, true, caption, fonts).letters < kCaptionType ||
        width * height + rows.shown() < kWorthASide * inRows.shown())
        return false;
    layout.caption.clear();
    layout.isFirstLarge = layout.hasCaptionBeside = true;
    layout.content = content;
    layout.captionTop = content.corner.y + content.size.y;
    placePictures(layout, {content.corner + dvec2(width + kGap, 0), {smallWidth, content.size.y}}, rows, small);
    layout.labels.insert(layout.labels.begin(), Box{content.corner, {width, label}});
    layout.cells.insert(layout.cells.begin(), Box{content.corner + dvec2(0, label), {width, height}});
    layout.legends.insert(layout.legends.begin(), Box{content.corner + dvec2(0, foot), {width, legend}});
    const Box& last = layout.cells.back();
    layout.words = {last.corner + dvec2(last.size.x + kGap, 0), caption};
    layout.pictures = {content.corner, dvec2(width + kGap, 0) + layout.pictures.size};
    return true;
}

/// Where the pictures leave more room above the slide's foot than a caption needs, it is set larger.
void enlargeCaption(SlideLayout& layout, const std::string& caption, double foot, const Fonts& fonts) {
    if (caption.empty()) return;
    for (const double type : {36.0, 32.0, kCaptionType}) {
        layout.captionType = type;
        layout.caption = drawing::wrapProse(caption, type, layout.content.size.x, false, fonts.formula());
        if (layout.captionTop + kLineHeight * type * static_cast<double>(layout.caption.size()) <= foot) return;
    }
}

/// Beside the pictures: all that they leave free.
Box besidePictures(const SlideLayout& layout) {
    const double left = layout.pictures.corner.x + layout.pictures.size.x + kGap;
    const Box& content = layout.content;
    return {{left, content.corner.y}, {content.corner.x + content.size.x - left, content.size.y}};
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
    const double foot = kSlideHeight - 2 * kLineHeight * kFootType;
    const double bottom = foot - kLineHeight * kCaptionType * static_cast<double>(layout.caption.size());
    layout.content = {{kMargin, top}, {room, bottom - top}};
    layout.captionTop = bottom + 0.1 * kCaptionType;
    const bool hasWords = !slide.text.empty() || !slide.formulas.empty() || !slide.pseudocode.empty();
    if (hasWords) layout.words = layout.content;
    if (needs.empty()) return layout;
    Box area = layout.content;
    if (hasWords) area.size.x -= wordsWidth(slide, area.size, fonts) + kGap;
    const Rows rows = largest(needs, area.size, fonts);
    if (hasWords) {
        placePictures(layout, area, rows, needs);
        layout.words = besidePictures(layout);
    } else if (!layout.caption.empty() && placeFirstLarge(layout, slide, {{kMargin, top}, {room, foot - top}}, rows, needs, fonts)) {
        // placed, and the caption with them
    } else if (!layout.caption.empty() && placeBesideCaption(layout, slide, {{kMargin, top}, {room, foot - top}}, rows, needs, fonts)) {
        layout.words = besidePictures(layout);
    } else { // a caption belongs to what it is about
        placePictures(layout, area, rows, needs);
        layout.content.size.y = layout.pictures.size.y;
        layout.captionTop = top + layout.content.size.y + 0.1 * kCaptionType;
        enlargeCaption(layout, slide.written.caption, foot, fonts);
    }
    return layout;
}

} // namespace shadowlab::course
