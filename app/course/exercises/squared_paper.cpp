// SPDX-License-Identifier: MIT
#include "app/course/exercises/squared_paper.h"

namespace shadowlab::course {

namespace {

constexpr double kLeftMargin = 56, kTopMargin = 48, kRightMargin = 36,
                 kBottomMargin = 60; // for the numbers of the axes
const drawing::Stroke kSquares{"#c8c8c8", 1.5};

dvec2 sheetSize(dvec2 lower, dvec2 upper) {
    return SquaredPaper::kSquare * (upper - lower) + dvec2(kLeftMargin + kRightMargin, kTopMargin + kBottomMargin);
}

} // namespace

SquaredPaper::SquaredPaper(dvec2 lower, dvec2 upper, std::string_view firstAxis, std::string_view secondAxis,
                           bool secondGoesDown)
    : lower_(lower), upper_(upper), secondGoesDown_(secondGoesDown), drawing_(sheetSize(lower, upper)) {
    const drawing::TextStyle numbers{
        .size = 21, .anchor = drawing::Anchor::middle, .color = "#555555", .hasRim = false};
    for (int x = static_cast<int>(lower.x); x <= static_cast<int>(upper.x); ++x) {
        line({x, lower.y}, {x, upper.y}, kSquares);
        drawing_.text({at({x, 0}).x, drawing_.size().y - kBottomMargin + 26}, std::to_string(x), numbers);
    }
    drawing::TextStyle atLeft = numbers;
    atLeft.anchor = drawing::Anchor::end;
    for (int y = static_cast<int>(lower.y); y <= static_cast<int>(upper.y); ++y) {
        line({lower.x, y}, {upper.x, y}, kSquares);
        drawing_.text({kLeftMargin - 14, at({0, y}).y + 6}, std::to_string(y), atLeft);
    }
    drawing::TextStyle names = numbers;
    names.isItalic = true;
    drawing_.text({0.5 * (at(lower).x + at(upper).x), drawing_.size().y - 10}, firstAxis, names);
    // Above the uppermost number, and clear of it, whichever way the axis goes: at the lower end it would meet the numbers of the other one.
    drawing_.text({kLeftMargin - 20, kTopMargin - 26}, secondAxis, names);
}

dvec2 SquaredPaper::at(dvec2 place) const {
    const double down = secondGoesDown_ ? place.y - lower_.y : upper_.y - place.y;
    return dvec2(kLeftMargin + kSquare * (place.x - lower_.x), kTopMargin + kSquare * down);
}

void SquaredPaper::line(dvec2 from, dvec2 to, const drawing::Stroke& stroke) {
    drawing_.line(at(from), at(to), stroke);
}

void SquaredPaper::box(dvec2 lower, dvec2 upper, const std::string& fill) {
    const dvec2 a = at(lower), b = at(upper);
    drawing_.rectangle(glm::min(a, b), glm::abs(b - a), fill, {"#1a1a1a", 2.5});
}

void SquaredPaper::point(dvec2 place, std::string_view name, const std::string& color, dvec2 labelOffsetPx) {
    drawing_.circle(at(place), 7, color, {"#ffffff", 1.5});
    drawing_.text(at(place) + labelOffsetPx, name,
                  {.size = kLabel,
                   .anchor = labelOffsetPx.x < 0 ? drawing::Anchor::end : drawing::Anchor::start,
                   .isBold = true});
}

void SquaredPaper::label(dvec2 place, std::string_view text, drawing::Anchor anchor) {
    drawing_.text(at(place), text, {.size = kLabel, .anchor = anchor});
}

} // namespace shadowlab::course
