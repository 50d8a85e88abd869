// SPDX-License-Identifier: MIT
#include "techniques/foundation/trace/area/sphere_cuts.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <glm/gtc/constants.hpp>

#include "techniques/foundation/math/perpendicular.h"
#include "techniques/foundation/trace/area/shaft.h"

namespace shadowlab::trace {

namespace {

constexpr double kChordsOfCircle = 32;

// Bits of the numbers by which circles are compared: a body with more faces in the sphere is seldom convex there.
constexpr std::uint32_t kMostCompared = 64;

// Triangles of a wall have the same plane up to rounding, of coordinates a million times the sphere.
constexpr double kSamePlane = 1e-9;

// Where chords of two walls meet, each reaches so far beyond the other's plane, in radii of the sphere: by what it is moved outward.
constexpr double kMovedOutward = 0.004;

/// The chord of a part of the circle, moved outward so that it encloses as much: a sector of one radian has half the square of the radius, its
/// chord's triangle that times sine over angle.
SphereCut chordOf(const CutCircle& circle, double begin, double end) {
    const double turn = end - begin, stretch = std::sqrt(turn / std::sin(turn));
    return {0, 0, begin, end, circle.place(begin, stretch), circle.place(end, stretch)};
}

/// One side of the triangle: a place is within where the product with the normal is not smaller than the level.
struct Side {
    dvec3 normal; ///< unit, in the triangle's plane
    double level;
};

std::array<Side, 3> sidesOf(const Triangle& t, const dvec3& front) {
    std::array<Side, 3> sides;
    const std::array<dvec3, 3> corners = {t.a, t.b, t.c};
    for (std::size_t i = 0; i < 3; ++i) {
        const dvec3 normal = glm::normalize(glm::cross(front, corners[(i + 1) % 3] - corners[i]));
        sides[i] = {normal, glm::dot(normal, corners[i])};
    }
    return sides;
}

/// The angles at which the circle enters or leaves the triangle, and perhaps others; in order, over one turn.
std::vector<double> anglesAtSides(const CutCircle& circle, const std::array<Side, 3>& sides) {
    std::vector<double> angles;
    for (const Side& side : sides) {
        // On the circle the product is a cosine around the angle at which the circle is farthest within.
        const double within = std::atan2(glm::dot(side.normal, circle.v), glm::dot(side.normal, circle.u));
        const double cosine = (side.level - glm::dot(side.normal, circle.middle)) / circle.radius;
        if (!(std::abs(cosine) < 1)) continue;
        for (const double aside : {-std::acos(cosine), std::acos(cosine)}) {
            const double angle = within + aside;
            angles.push_back(angle - glm::two_pi<double>() * std::floor(angle / glm::two_pi<double>()));
        }
    }
    if (angles.empty()) angles.push_back(0);
    std::ranges::sort(angles);
    angles.push_back(angles.front() + glm::two_pi<double>());
    return angles;
}

/// The part of a circle from one angle to another that is before the disc that a point sees of the sphere; none: the second is not larger.
dvec2 nearPart(const CutCircle& circle, double begin, double end, const dvec3& toCircle, const dvec3& toCentre, double toDisc) {
    // Along the circle the product with the way to the centre, less that of the disc's places, is sum + swing * cos(angle - farthest).
    const double alongU = glm::dot(toCentre, circle.u), alongV = glm::dot(toCentre, circle.v);
    const double sum = glm::dot(toCentre, toCircle) - toDisc, swing = circle.radius * std::hypot(alongU, alongV);
    if (sum + swing <= 0) return {begin, end};
    if (sum - swing >= 0) return {begin, begin};
    const double nearest = std::atan2(-alongV, -alongU), half = std::acos(sum / swing);
    const double turns = glm::two_pi<double>() * std::round((0.5 * (begin + end) - nearest) / glm::two_pi<double>());
    return {std::max(begin, nearest + turns - half), std::min(end, nearest + turns + half)};
}

} // namespace

CutCircle::CutCircle(const dvec3& planeNormal, double planeLevel, const dvec3& centreCentred, double sphereRadius)
    : normal(planeNormal), level(planeLevel), u(perpendicularTo(normal)), v(glm::cross(normal, u)) {
    const double above = height(centreCentred);
    middle = centreCentred - above * normal;
    radius = std::sqrt(std::max((sphereRadius - above) * (sphereRadius + above), 0.0));
}

void SphereCuts::add(const Triangle& triangle, std::uint32_t primitive) {
    const dvec3 front = frontOf(triangle);
    if (!(glm::length(front) > 0)) return;
    const dvec3 normal = glm::normalize(front);
    const CutCircle own(normal, glm::dot(normal, triangle.a), centreCentred_, radius_);
    if (!(own.radius > 0)) return;
    const std::uint32_t number = numberOf(own);
    const CutCircle circle = number < circles_.size() ? circles_[number] : own;
    const std::array<Side, 3> sides = sidesOf(triangle, front);
    const std::vector<double> angles = anglesAtSides(circle, sides);
    for (std::size_t i = 0; i + 1 < angles.size(); ++i) {
        const double width = angles[i + 1] - angles[i];
        const dvec3 middle = circle.place(angles[i] + 0.5 * width);
        const auto isWithin = [&](const Side& side) { return glm::dot(side.normal, middle) >= side.level; };
        if (!(width > 0) || !std::ranges::all_of(sides, isWithin)) continue;
        if (number == circles_.size()) addCircle(circle);
        const int count = std::max(1, static_cast<int>(std::ceil(kChordsOfCircle * width / glm::two_pi<double>())));
        for (int chord = 0; chord < count; ++chord) {
            const double begin = angles[i] + chord * width / count;
            chords_.push_back(chordOf(circle, begin, begin + width / count));
            chords_.back().primitive = primitive;
            chords_.back().circle = number;
            for (std::uint32_t other = 0; other < sides_.size(); ++other) compare(other, chords_.back());
        }
    }
}

/// The number of the circle that is the same; if there is none, that of the next to be added.
std::uint32_t SphereCuts::numberOf(const CutCircle& circle) const {
    const auto isSame = [&](const CutCircle& other) {
        return glm::length(other.normal - circle.normal) < kSamePlane && std::abs(other.level - circle.level) < kSamePlane * radius_;
    };
    // Among those that are compared; of others it does not matter.
    const auto compared = std::span(circles_).first(sides_.size());
    const auto found = std::ranges::find_if(compared, isSame);
    return static_cast<std::uint32_t>(found == compared.end() ? circles_.size() : static_cast<std::size_t>(found - compared.begin()));
}

void SphereCuts::addCircle(const CutCircle& circle) {
    circles_.push_back(circle);
    if (sides_.size() == kMostCompared) return;
    sides_.emplace_back();
    for (const SphereCut& chord : chords_) compare(static_cast<std::uint32_t>(circles_.size() - 1), chord);
}

void SphereCuts::compare(std::uint32_t circle, const SphereCut& chord) {
    if (chord.circle >= kMostCompared) return;
    const double first = circles_[circle].height(chord.firstCentred), second = circles_[circle].height(chord.secondCentred);
    const std::uint64_t bit = std::uint64_t{1} << chord.circle;
    if (std::min(first, second) < -kMovedOutward * radius_) sides_[circle].before &= ~bit;
    if (std::max(first, second) > kMovedOutward * radius_) sides_[circle].behind &= ~bit;
}

bool SphereCuts::boundOneConvexPart(std::span<const std::uint32_t> chords, const dvec3& positionCentred) const {
    std::uint64_t present = 0;
    for (const std::uint32_t chord : chords) {
        if (chords_[chord].circle >= kMostCompared) return false;
        present |= std::uint64_t{1} << chords_[chord].circle;
    }
    const double rounding = kInPlane * glm::distance(positionCentred, centreCentred_);
    for (std::size_t i = 0; i < sides_.size(); ++i) {
        if ((present >> i & 1) == 0) continue;
        const double height = circles_[i].height(positionCentred);
        const std::uint64_t onThisSide = height > rounding ? sides_[i].before : height < -rounding ? sides_[i].behind : 0;
        if ((present & ~onThisSide) != 0) return false;
    }
    return true;
}

dvec3 SphereCuts::inward(std::uint32_t chord, const dvec3& positionCentred) const {
    SphereCut cut = chords_[chord];
    const CutCircle& circle = circles_[cut.circle];
    const dvec3 toCentre = centreCentred_ - positionCentred;
    const double toDisc = glm::dot(toCentre, toCentre) - radius_ * radius_; // the square of a tangent
    const auto isNear = [&](const dvec3& placeCentred) { return glm::dot(toCentre, placeCentred - positionCentred) < toDisc; };
    if (!isNear(cut.firstCentred) || !isNear(cut.secondCentred)) {
        const dvec2 near = nearPart(circle, cut.begin, cut.end, circle.middle - positionCentred, toCentre, toDisc);
        if (near.x >= near.y) return dvec3(0.0);
        cut = chordOf(circle, near.x, near.y);
    }
    const dvec3 normal = glm::cross(cut.firstCentred - positionCentred, cut.secondCentred - positionCentred);
    return circle.height(positionCentred) > 0 ? -normal : normal;
}

} // namespace shadowlab::trace
