// SPDX-License-Identifier: MIT
#include "techniques/foundation/trace/area/uniform_pieces.h"

#include <algorithm>
#include <cmath>

namespace shadowlab::trace {

namespace {

// A corner counts as lying on a line where the line's function is smaller than this share of its largest terms: some
// thousand roundings, and 1e-12 of the polygon's width.
constexpr double kOnLine = 1e-12;

// With so few contours in a piece, each is compared with each other.
constexpr std::size_t kFew = 24;

// Contours that meet in one place cannot be told apart by halving, so it ends after so many times: pieces of a 4096th.
constexpr int kMostHalvings = 12;

double valueAt(const dvec3& function, dvec2 place) { return function.x * place.x + function.y * place.y + function.z; }

double roundingOf(const dvec3& function, dvec2 place) {
    return kOnLine * (std::abs(function.x * place.x) + std::abs(function.y * place.y) + std::abs(function.z));
}

/// The sign of the function there; 0: on its line.
int sideOf(const dvec3& function, dvec2 place) {
    const double value = valueAt(function, place), rounding = roundingOf(function, place);
    return value > rounding ? 1 : value < -rounding ? -1 : 0;
}

/// Leaves out what of the way from begin to end lies where the function is negative; false: all of it does.
bool keepPart(dvec2& begin, dvec2& end, const dvec3& function) {
    const double atBegin = valueAt(function, begin), atEnd = valueAt(function, end);
    if (atBegin < 0 && atEnd < 0) return false;
    if (atBegin < 0)
        begin += atBegin / (atBegin - atEnd) * (end - begin);
    else if (atEnd < 0)
        end = begin + atBegin / (atBegin - atEnd) * (end - begin);
    return true;
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

void keepPart(std::vector<dvec2>& polygon, const dvec3& function) {
    thread_local std::vector<dvec2> kept; // asked many times for each point
    kept.clear();
    clip(
        polygon.size(), [&](std::size_t i) { return polygon[i]; }, function, 1.0,
        [&](dvec2 corner) { kept.push_back(corner); });
    polygon.swap(kept);
}

void UniformPieces::cut(std::span<const dvec2> outline, std::span<const dvec3> borders, std::span<const Contour> contours, const Visit& visit) {
    contours_ = contours;
    visit_ = &visit;
    corners_.assign(outline.begin(), outline.end());
    parts_.clear();
    Range within{0, corners_.size()};
    for (std::size_t i = 0; i < contours.size(); ++i)
        addPart(static_cast<std::uint32_t>(i), within);
    Range parts{0, parts_.size()};
    for (const dvec3& border : borders) {
        const std::size_t cornersThere = corners_.size(), partsThere = parts_.size();
        if (const Range beyond = stillWithin(parts, partsThere, border, -1); beyond.count > 0)
            settle(keptSide(within, border, -1), beyond, 0);
        corners_.resize(cornersThere);
        parts_.resize(partsThere);
        within = keptSide(within, border, 1);
        parts = stillWithin(parts, partsThere, border, 1);
    }
    settle(within, parts, 0);
}

/// If any of it lies within the piece.
void UniformPieces::addPart(std::uint32_t contour, Range piece) {
    const dvec3& line = contours_[contour].line;
    bool left = false, right = false;
    Part part{contour, {}, {}};
    for (std::size_t i = 0; i < piece.count; ++i) {
        const dvec2 here = corners_[piece.first + i], next = corners_[piece.first + (i + 1) % piece.count];
        const int side = sideOf(line, here);
        left = left || side > 0;
        right = right || side < 0;
        const double atHere = valueAt(line, here), atNext = valueAt(line, next);
        if ((atHere >= 0) == (atNext >= 0)) continue;
        // A line leaves a convex piece in one place, and enters it in another.
        (atHere >= 0 ? part.begin : part.end) = here + atHere / (atHere - atNext) * (next - here);
    }
    if (left && right && keepPart(part.begin, part.end, contours_[contour].from) &&
        keepPart(part.begin, part.end, contours_[contour].to))
        parts_.push_back(part);
}

void UniformPieces::settle(Range piece, Range within, int halvings) {
    if (piece.count < 3) return;
    if (within.count == 0) {
        (*visit_)(std::span(corners_).subspan(piece.first, piece.count));
        return;
    }
    const bool halves = within.count > kFew && halvings < kMostHalvings;
    const std::size_t used = halves ? parts_.size() : bestCut(within);
    const dvec3 line = halves ? halving(piece) : contours_[parts_[used].contour].line;
    const std::size_t corners = corners_.size(), parts = parts_.size();
    for (const double sign : {1.0, -1.0}) {
        const Range side = keptSide(piece, line, sign);
        settle(side, stillWithin(within, used, line, sign), halvings + (halves ? 1 : 0));
        corners_.resize(corners);
        parts_.resize(parts);
    }
}

/// A line across the middle of the piece, where it is longer.
dvec3 UniformPieces::halving(Range piece) const {
    dvec2 lower = corners_[piece.first], upper = lower;
    for (std::size_t i = 1; i < piece.count; ++i) {
        lower = glm::min(lower, corners_[piece.first + i]);
        upper = glm::max(upper, corners_[piece.first + i]);
    }
    const dvec2 middle = 0.5 * (lower + upper);
    return upper.x - lower.x > upper.y - lower.y ? dvec3(1, 0, -middle.x) : dvec3(0, 1, -middle.y);
}

/// The part whose line splits fewest others.
std::size_t UniformPieces::bestCut(Range within) const {
    std::size_t best = within.first, least = within.count;
    for (std::size_t i = within.first; i < within.first + std::min(within.count, kFew) && least > 0; ++i)
        if (const std::size_t split = splitBy(contours_[parts_[i].contour].line, within, least); split < least) {
            least = split;
            best = i;
        }
    return best;
}

/// How many parts the line splits; stops counting at `atMost`.
std::size_t UniformPieces::splitBy(const dvec3& line, Range within, std::size_t atMost) const {
    std::size_t split = 0;
    for (std::size_t i = within.first; i < within.first + within.count && split < atMost; ++i) {
        const Part& part = parts_[i];
        if ((valueAt(line, part.begin) < 0) != (valueAt(line, part.end) < 0) &&
            sideOf(line, part.begin) * sideOf(line, part.end) < 0)
            ++split;
    }
    return split;
}

UniformPieces::Range UniformPieces::keptSide(Range piece, const dvec3& line, double sign) {
    const std::size_t first = corners_.size();
    clip(
        piece.count, [&](std::size_t i) { return corners_[piece.first + i]; }, line, sign,
        [&](dvec2 corner) { corners_.push_back(corner); });
    return {first, corners_.size() - first};
}

/// Of parts that lay within a piece, those that lie within one side of its cut.
UniformPieces::Range UniformPieces::stillWithin(Range among, std::size_t except, const dvec3& line, double sign) {
    const std::size_t first = parts_.size();
    for (std::size_t i = among.first; i < among.first + among.count; ++i) {
        Part part = parts_[i];
        const dvec3 function = sign * line;
        const int atBegin = sideOf(function, part.begin), atEnd = sideOf(function, part.end);
        if (i == except || (atBegin <= 0 && atEnd <= 0)) continue;
        if (atBegin < 0 || atEnd < 0) keepPart(part.begin, part.end, function);
        parts_.push_back(part);
    }
    return {first, parts_.size() - first};
}

} // namespace shadowlab::trace
