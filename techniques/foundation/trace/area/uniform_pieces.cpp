// SPDX-License-Identifier: MIT
#include "techniques/foundation/trace/area/uniform_pieces.h"

#include <algorithm>
#include <cmath>

namespace shadowlab::trace {

namespace {

// A corner counts as lying on a line where the line's function is smaller than this share of its largest terms: some
// thousand roundings, and 1e-12 of the polygon's width.
constexpr double kOnLine = 1e-12;

// With so few contours in a piece, halving it first gains nothing.
constexpr std::size_t kFew = 6;

// Contours that meet in one place cannot be told apart by halving, so it ends after so many times: pieces of a 4096th.
constexpr int kMostHalvings = 12;

double valueAt(const dvec3& function, dvec2 place) { return function.x * place.x + function.y * place.y + function.z; }

double roundingOf(const dvec3& function, dvec2 place) {
    return kOnLine * (std::abs(function.x * place.x) + std::abs(function.y * place.y) + std::abs(function.z));
}

/// Calls add(corner) for the part where sign times the function is not negative.
template <typename Corner, typename Add>
void clip(std::size_t count, const Corner& corner, const dvec3& function, double sign, const Add& add) {
    for (std::size_t i = 0; i < count; ++i) {
        const dvec2 here = corner(i), next = corner((i + 1) % count);
        const double atHere = sign * valueAt(function, here), atNext = sign * valueAt(function, next);
        if (atHere >= 0) add(here);
        // Computed from the same two numbers on both sides, so that both parts get exactly the same corner.
        if ((atHere > 0 && atNext < 0) || (atHere < 0 && atNext > 0)) {
            const bool turned = atHere < 0;
            const dvec2 from = turned ? next : here, to = turned ? here : next;
            const double a = turned ? atNext : atHere, b = turned ? atHere : atNext;
            add(from + a / (a - b) * (to - from));
        }
    }
}

} // namespace

double areaOf(std::span<const dvec2> polygon) {
    double twice = 0;
    for (std::size_t i = 2; i < polygon.size(); ++i) {
        const dvec2 a = polygon[i - 1] - polygon[0], b = polygon[i] - polygon[0];
        twice += a.x * b.y - a.y * b.x;
    }
    return 0.5 * twice;
}

dvec2 centroidOf(std::span<const dvec2> polygon) {
    dvec2 sum(0.0);
    double weight = 0;
    for (std::size_t i = 2; i < polygon.size(); ++i) {
        const dvec2 a = polygon[i - 1] - polygon[0], b = polygon[i] - polygon[0];
        const double area = a.x * b.y - a.y * b.x;
        sum += area * (a + b) / 3.0;
        weight += area;
    }
    return weight > 0 ? polygon[0] + sum / weight : polygon[0];
}

std::vector<dvec2> keptPart(std::span<const dvec2> polygon, const dvec3& function) {
    std::vector<dvec2> kept;
    clip(
        polygon.size(), [&](std::size_t i) { return polygon[i]; }, function, 1.0,
        [&](dvec2 corner) { kept.push_back(corner); });
    return kept;
}

void UniformPieces::cut(std::span<const dvec2> outline, std::span<const Contour> contours, const Visit& visit) {
    contours_ = contours;
    visit_ = &visit;
    corners_.assign(outline.begin(), outline.end());
    chosen_.clear();
    const Range whole{0, corners_.size()};
    for (std::size_t i = 0; i < contours.size(); ++i)
        if (crosses(contours[i], whole)) chosen_.push_back(static_cast<std::uint32_t>(i));
    settle(whole, {0, chosen_.size()}, 0);
}

void UniformPieces::settle(Range piece, Range within, int halvings) {
    if (piece.count < 3) return;
    if (within.count == 0) {
        (*visit_)(std::span(corners_).subspan(piece.first, piece.count));
        return;
    }
    const std::size_t none = contours_.size();
    std::size_t used = none;
    dvec3 line;
    if (within.count > kFew && halvings < kMostHalvings) {
        dvec2 lower = corners_[piece.first], upper = lower;
        for (std::size_t i = 1; i < piece.count; ++i) {
            lower = glm::min(lower, corners_[piece.first + i]);
            upper = glm::max(upper, corners_[piece.first + i]);
        }
        const dvec2 middle = 0.5 * (lower + upper);
        line = upper.x - lower.x > upper.y - lower.y ? dvec3(1, 0, -middle.x) : dvec3(0, 1, -middle.y);
        ++halvings;
    } else {
        used = chosen_[within.first];
        line = contours_[used].line;
    }
    const std::size_t corners = corners_.size(), chosen = chosen_.size();
    for (const double sign : {1.0, -1.0}) {
        const Range side = keptSide(piece, line, sign);
        settle(side, stillWithin(side, within, used), halvings);
        corners_.resize(corners);
        chosen_.resize(chosen);
    }
}

UniformPieces::Range UniformPieces::keptSide(Range piece, const dvec3& line, double sign) {
    const std::size_t first = corners_.size();
    clip(
        piece.count, [&](std::size_t i) { return corners_[piece.first + i]; }, line, sign,
        [&](dvec2 corner) { corners_.push_back(corner); });
    return {first, corners_.size() - first};
}

UniformPieces::Range UniformPieces::stillWithin(Range piece, Range among, std::size_t except) {
    const std::size_t first = chosen_.size();
    for (std::size_t i = among.first; i < among.first + among.count; ++i)
        if (chosen_[i] != except && crosses(contours_[chosen_[i]], piece)) chosen_.push_back(chosen_[i]);
    return {first, chosen_.size() - first};
}

bool UniformPieces::crosses(const Contour& contour, Range piece) const {
    bool left = false, right = false, afterFrom = false, beforeTo = false;
    double before = 0;
    for (std::size_t i = 0; i <= piece.count; ++i) {
        const dvec2 here = corners_[piece.first + i % piece.count];
        const double value = valueAt(contour.line, here), rounding = roundingOf(contour.line, here);
        left = left || value > rounding;
        right = right || value < -rounding;
        if (i > 0 && ((before >= 0 && value <= 0) || (before <= 0 && value >= 0))) {
            // Here the line leaves or enters the piece: does its part begin after both such places, or end before them?
            const dvec2 last = corners_[piece.first + i - 1];
            const dvec2 place = before == value ? here : last + before / (before - value) * (here - last);
            afterFrom = afterFrom || valueAt(contour.from, place) >= -roundingOf(contour.from, place);
            beforeTo = beforeTo || valueAt(contour.to, place) >= -roundingOf(contour.to, place);
        }
        before = value;
    }
    return left && right && afterFrom && beforeTo;
}

} // namespace shadowlab::trace
