// SPDX-License-Identifier: MIT
#include "techniques/foundation/trace/area/light_piece.h"

#include <algorithm>
#include <cmath>

#include <glm/gtc/constants.hpp>

#include "techniques/foundation/trace/area/uniform_pieces.h"

namespace shadowlab::trace {

namespace {

double crossOf(dvec2 a, dvec2 b) { return a.x * b.y - a.y * b.x; }

// By rounding an arc's end may come before its begin. A side that cuts off nearly all of the disc leaves no such arc: half of a
// chord is the root of what it misses of the radius, twice, so it is 0 or at least 1e-8.
constexpr double kTurnedByRounding = 1e-9;

/// The angle from one place of the circle to another, counter-clockwise.
double arcBetween(dvec2 begin, dvec2 end) {
    const double angle = std::atan2(crossOf(begin, end), glm::dot(begin, end));
    return angle >= 0 ? angle : angle > -kTurnedByRounding ? 0 : angle + glm::two_pi<double>();
}

/// The share of a line's way from `begin` to `end` at which it enters the unit circle, and at which it leaves; the second is not
/// larger if it does not.
dvec2 withinCircle(dvec2 begin, dvec2 end) {
    const dvec2 way = end - begin;
    const double squared = glm::dot(way, way);
    if (!(squared > 0)) return {0, 0};
    if (glm::dot(begin, begin) <= 1 && glm::dot(end, end) <= 1) return {0, 1};
    const double aside = crossOf(begin, way) / std::sqrt(squared); // of the line, from the middle
    const double halfChord = std::sqrt(std::max((1 - aside) * (1 + aside), 0.0) / squared);
    const double nearest = -glm::dot(begin, way) / squared;
    return {std::max(nearest - halfChord, 0.0), std::min(nearest + halfChord, 1.0)};
}

// The square of a tangent below which its series is right to the rounding of double, with as many terms as there are.
constexpr double kShort = 0.01;

/// atan(x) / x by the square of x.
double arcOverTangent(double squared) {
    double sum = 0;
    for (int term = 15; term >= 1; term -= 2) sum = 1.0 / term - squared * sum;
    return sum;
}

} // namespace

LightPiece::LightPiece(const SeenLight& seen, std::span<const dvec2> polygon) : seen_(seen), polygon_(polygon) {
    if (seen.isDisc)
        cutWithDisc();
    else
        area_ = areaOf(polygon);
}

void LightPiece::cutWithDisc() {
    parts_.reserve(polygon_.size());
    bool isAround = polygon_.size() > 2; // is the disc's middle to the left of all sides?
    for (std::size_t i = 0; i < polygon_.size(); ++i) {
        const dvec2 begin = polygon_[i], end = polygon_[(i + 1) % polygon_.size()];
        isAround = isAround && crossOf(begin, end) > 0;
        const dvec2 within = withinCircle(begin, end);
        if (within.x >= within.y) continue;
        parts_.push_back({within.x > 0 ? glm::mix(begin, end, within.x) : begin,
                          within.y < 1 ? glm::mix(begin, end, within.y) : end});
    }
    if (parts_.empty()) {
        isWholeDisc_ = isAround;
        area_ = isAround ? seen_.area : 0;
        return;
    }
    double twice = 0;
    for (std::size_t i = 0; i < parts_.size(); ++i) {
        const dvec2 next = parts_[(i + 1) % parts_.size()].begin;
        if (parts_[i].end != next) parts_[i].arc = arcBetween(parts_[i].end, next);
        twice += crossOf(parts_[i].begin, parts_[i].end) + parts_[i].arc;
    }
    area_ = std::max(0.5 * twice, 0.0);
}

dvec2 LightPiece::middle() const {
    if (isWholeDisc_) return dvec2(0.0);
    if (!seen_.isDisc) return centroidOf(polygon_);
    // Corners within it: those it has, and two on each arc, so that also a piece with one side is more than a line.
    std::vector<dvec2> corners;
    for (const Part& part : parts_) {
        corners.push_back(part.begin);
        corners.push_back(part.end);
        for (const double share : {1.0 / 3, 2.0 / 3}) {
            const double turn = share * part.arc;
            if (turn > 0)
                corners.push_back(std::cos(turn) * part.end + std::sin(turn) * dvec2(-part.end.y, part.end.x));
        }
    }
    return centroidOf(corners);
}

dvec3 LightPiece::vectorIrradiance() const {
    dvec3 sum(0.0);
    if (isWholeDisc_) sum = alongArc({1, 0}, {1, 0}, glm::two_pi<double>());
    if (!seen_.isDisc)
        for (std::size_t i = 0; i < polygon_.size(); ++i)
            sum += alongSide(polygon_[i], polygon_[(i + 1) % polygon_.size()]);
    for (std::size_t i = 0; i < parts_.size(); ++i) {
        sum += alongSide(parts_[i].begin, parts_[i].end);
        if (parts_[i].arc > 0) sum += alongArc(parts_[i].end, parts_[(i + 1) % parts_.size()].begin, parts_[i].arc);
    }
    // Counter-clockwise on the light may be clockwise as seen from the point.
    const bool turned = glm::dot(glm::cross(seen_.axisU, seen_.axisV), seen_.middle) < 0;
    return (turned ? -0.5 : 0.5) * sum;
}

/// The integral of r x dr: a straight side is seen as a part of a great circle.
dvec3 LightPiece::alongSide(dvec2 begin, dvec2 end) const {
    const dvec3 from = seen_.toward(begin), to = seen_.toward(end), normal = glm::cross(from, to);
    const double along = glm::dot(from, to), squared = glm::dot(normal, normal);
    if (along > 0 && squared < kShort * along * along) return arcOverTangent(squared / (along * along)) / along * normal;
    const double length = std::sqrt(squared);
    return length > 0 ? std::atan2(length, along) / length * normal : dvec3(0.0);
}

/// The same along the circle, which is seen around the way a to its middle: with r = cos a + sin (cos t u + sin t v), the cone's
/// half angle being meant where none is named, r x dr = (sin^2 a - sin cos (cos t u + sin t v)) dt.
dvec3 LightPiece::alongArc(dvec2 begin, dvec2 end, double angle) const {
    const double radius = glm::length(seen_.axisU), distance = glm::length(seen_.middle);
    const double slant = std::hypot(radius, distance), sine = radius / slant, cosine = distance / slant;
    const dvec2 across = sine * cosine * dvec2(end.y - begin.y, begin.x - end.x); // of cos t and sin t
    return sine * sine * angle / distance * seen_.middle -
           (across.x / radius * seen_.axisU + across.y / radius * seen_.axisV);
}

} // namespace shadowlab::trace
