// SPDX-License-Identifier: MIT
#include "app/drawing/labels.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include <glm/gtc/constants.hpp>

namespace shadowlab::drawing {

namespace {

constexpr int kPlacesAround = 16;
constexpr double kStep = 14;       ///< pixels between the rings that are tried
constexpr int kRings = 14;         ///< the farthest is some 200 pixels away
constexpr double kBolder = 1.12;   ///< of bold letters, in the widths of the others that are measured
constexpr double kAir = 4;         ///< pixels around a label
constexpr double kLineCost = 240;  ///< of crossing a line: more than going to the farthest ring
constexpr double kLeaderFrom = 26; ///< pixels from which on a thin line says what a label belongs to

constexpr double kIndexDrop = 0.18; ///< em by which an index stands lower than its letter

constexpr double kShortest = 6; ///< of such a line

/// Does the segment touch the box? Clipped to it, by Liang and Barsky (1984).
bool touches(dvec2 from, dvec2 to, const Box& box) {
    double enter = 0, leave = 1;
    for (int axis = 0; axis < 2; ++axis) {
        const double way = to[axis] - from[axis];
        const double low = box.corner[axis] - from[axis], high = low + box.size[axis];
        if (way == 0) {
            if (low > 0 || high < 0) return false;
            continue;
        }
        enter = std::max(enter, std::min(low / way, high / way));
        leave = std::min(leave, std::max(low / way, high / way));
    }
    return enter <= leave;
}

} // namespace

dvec2 textSize(const image::Font& font, std::string_view text, double em) {
    const image::TextSize size = font.measure(text, em);
    return {size.width, size.height};
}

/// Infinite where the label would leave the area or cover another one.
double Labels::cost(const Box& box) const {
    const dvec2 low = box.corner - area_.corner, high = low + box.size;
    if (low.x < 0 || low.y < 0 || high.x > area_.size.x || high.y > area_.size.y)
        return std::numeric_limits<double>::infinity();
    if (std::ranges::any_of(boxes_, [&](const Box& other) { return other.overlaps(box); }))
        return std::numeric_limits<double>::infinity();
    return kLineCost * static_cast<double>(std::ranges::count_if(
                           lines_, [&](const Line& line) { return touches(line.from, line.to, box); }));
}

bool Labels::place(Drawing& drawing, dvec2 anchor, const LabelText& text, const TextStyle& style, double away) {
    const double bolder = style.isBold ? kBolder : 1, indexSize = kIndexScale * style.size;
    const dvec2 letter = textSize(font_, text.letter, style.size);
    const double indexWidth = text.index.empty() ? 0 : bolder * textSize(font_, text.index, indexSize).x;
    const double restWidth = text.rest.empty() ? 0 : bolder * textSize(font_, text.rest, style.size).x;
    const dvec2 size(bolder * letter.x + indexWidth + restWidth,
                     letter.y + (text.index.empty() ? 0 : kIndexDrop * style.size));
    std::optional<Box> best;
    double least = std::numeric_limits<double>::infinity(), distance = 0;
    for (int ring = 0; ring < kRings; ++ring)
        for (int i = 0; i < kPlacesAround; ++i) {
            const double angle = glm::two_pi<double>() * (i + 0.5) / kPlacesAround, reach = away + kStep * ring;
            const dvec2 toward(std::cos(angle), std::sin(angle));
            // The box touches the ring with its nearest side.
            const dvec2 middle =
                anchor + reach * toward + 0.5 * size * glm::sign(toward) * glm::min(dvec2(1), glm::abs(toward) * 1.5);
            const Box box{middle - 0.5 * size - kAir, size + 2 * kAir};
            const double price = cost(box) + kStep * ring;
            if (price >= least) continue;
            least = price;
            best = box;
            distance = reach;
        }
    if (!best) return false;
    if (distance > kLeaderFrom) {
        const dvec2 end = glm::clamp(anchor, best->corner, best->corner + best->size);
        const dvec2 way = end - anchor; // from where the mark ends
        if (glm::length(way) > away + kShortest)
            drawing.line(anchor + away * glm::normalize(way), end, {"#8c8c8c", 1.5, false});
        avoid(anchor, end);
    }
    TextStyle placed = style;
    placed.anchor = Anchor::start;
    dvec2 foot = best->corner + dvec2(kAir, kAir + font_.measure(text.letter, style.size).baseline);
    drawing.text(foot, text.letter, placed);
    foot.x += bolder * letter.x;
    if (!text.index.empty()) {
        TextStyle lowered = placed;
        lowered.size = indexSize;
        drawing.text(foot + dvec2(0, kIndexDrop * style.size), text.index, lowered);
        foot.x += indexWidth;
    }
    if (!text.rest.empty()) drawing.text(foot, text.rest, placed);
    boxes_.push_back(*best);
    return true;
}

} // namespace shadowlab::drawing
