// SPDX-License-Identifier: MIT
#include "app/drawing/labels.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include <glm/gtc/constants.hpp>

#include "app/drawing/prose.h"

namespace shadowlab::drawing {

namespace {

constexpr int kPlacesAround = 16;
constexpr double kStep = 14;       ///< pixels between the rings that are tried
constexpr int kRings = 14;         ///< the farthest is some 200 pixels away
constexpr double kBolder = 1.12;   ///< of bold letters, in the widths of the others, where their own face is not given
constexpr double kAir = 4;         ///< pixels around a label
constexpr double kLineCost = 240;  ///< of crossing a line: more than going to the farthest ring
constexpr double kLeaderCost = 60; ///< of a thin line to a label that crosses another: as going some rings farther
constexpr double kLeaderFrom = 42; ///< pixels from which on a thin line says what a label belongs to: nearer it is seen

constexpr double kIndexDrop = 0.18; ///< em by which an index stands lower than its letter

constexpr double kShortest = 16; ///< of such a line; a shorter one looks like a speck

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

double turn(dvec2 a, dvec2 b) { return a.x * b.y - a.y * b.x; }

/// Do two segments cross, each with its ends on different sides of the other?
bool cross(dvec2 a, dvec2 b, dvec2 c, dvec2 d) {
    return turn(b - a, c - a) * turn(b - a, d - a) < 0 && turn(d - c, a - c) * turn(d - c, b - c) < 0;
}

/// The way from what is named to its label; empty where it is too short to be drawn.
std::optional<std::pair<dvec2, dvec2>> leaderTo(const Box& box, dvec2 anchor, double away) {
    const dvec2 end = glm::clamp(anchor, box.corner, box.corner + box.size), way = end - anchor; // from where the mark ends
    if (glm::length(way) <= away + kShortest) return std::nullopt;
    return std::pair(anchor + away * glm::normalize(way), end);
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

/// Lines that a line crosses, and labels that it runs through.
int Labels::crossedBy(dvec2 from, dvec2 to) const {
    return static_cast<int>(std::ranges::count_if(lines_, [&](const Line& line) { return cross(from, to, line.from, line.to); }) +
                            std::ranges::count_if(boxes_, [&](const Box& box) { return touches(from, to, box); }));
}

/// The best box of that size near a place, with the line that leads to it. Other labels keep away from both.
std::optional<Box> Labels::roomFor(Drawing& drawing, dvec2 anchor, dvec2 size, double away) {
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
            double price = cost(box) + kStep * ring;
            if (price >= least) continue;
            if (reach > kLeaderFrom)
                if (const auto leader = leaderTo(box, anchor, away)) price += kLeaderCost * crossedBy(leader->first, leader->second);
            if (price >= least) continue;
            least = price;
            best = box;
            distance = reach;
        }
    if (!best) return best;
    if (distance > kLeaderFrom) {
        if (const auto leader = leaderTo(*best, anchor, away)) {
            drawing.line(leader->first, leader->second, {"#8c8c8c", 1.5, false});
            avoid(leader->first, leader->second);
        }
    }
    boxes_.push_back(*best);
    return best;
}

bool Labels::place(Drawing& drawing, dvec2 anchor, const std::string& text, const TextStyle& style, double away) {
    if (text.find('$') == std::string::npos) return place(drawing, anchor, LabelText{text, "", ""}, style, away);
    const ProseLine line = proseInOneLine(text, style.size, style.isBold, fonts_);
    const image::TextSize letters = fonts_.upright.measure("P", style.size);
    const dvec2 size(proseWidth(line, style.size, style.isBold, fonts_), letters.height + kIndexDrop * style.size);
    const std::optional<Box> box = roomFor(drawing, anchor, size, away);
    if (!box) return false;
    TextStyle placed = style;
    placed.anchor = Anchor::start;
    drawProse(drawing, box->corner + dvec2(kAir, kAir + letters.baseline), line, placed, fonts_);
    return true;
}

bool Labels::place(Drawing& drawing, dvec2 anchor, const LabelText& text, const TextStyle& style, double away) {
    const image::Font& font = fonts_.upright;
    const bool hasBold = &fonts_.bold != &fonts_.upright;
    const image::Font& face = style.isBold ? fonts_.bold : font;
    const double bolder = style.isBold && !hasBold ? kBolder : 1, indexSize = kIndexScale * style.size;
    const auto width = [&](const std::string& words, double em) { return words.empty() ? 0 : bolder * textSize(face, words, em).x; };
    const double letterWidth = width(text.letter, style.size), indexWidth = width(text.index, indexSize);
    const dvec2 size(letterWidth + indexWidth + width(text.rest, style.size),
                     textSize(font, text.letter, style.size).y + (text.index.empty() ? 0 : kIndexDrop * style.size));
    const std::optional<Box> best = roomFor(drawing, anchor, size, away);
    if (!best) return false;
    TextStyle placed = style;
    placed.anchor = Anchor::start;
    dvec2 foot = best->corner + dvec2(kAir, kAir + font.measure(text.letter, style.size).baseline);
    drawing.text(foot, text.letter, placed);
    foot.x += letterWidth;
    if (!text.index.empty()) {
        TextStyle lowered = placed;
        lowered.size = indexSize;
        drawing.text(foot + dvec2(0, kIndexDrop * style.size), text.index, lowered);
        foot.x += indexWidth;
    }
    if (!text.rest.empty()) drawing.text(foot, text.rest, placed);
    return true;
}

} // namespace shadowlab::drawing
