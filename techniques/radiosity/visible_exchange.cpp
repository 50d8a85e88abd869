// SPDX-License-Identifier: MIT
#include "techniques/radiosity/visible_exchange.h"

#include <algorithm>
#include <cmath>

namespace shadowlab::radiosity {

namespace {

// Fewer lines than this tell next to nothing; more than a few thousand no more than a patch is worth.
constexpr double kFewestLines = 8, kMostLines = 4096;

/// The i-th of points that lie evenly in the unit square of four dimensions, for any number of them: multiples of powers of the
/// root of x^5 = x + 1 (M. Roberts, "The Unreasonable Effectiveness of Quasirandom Sequences", 2018).
std::array<double, 4> evenly(int i) {
    constexpr double kRoot = 1.1673039782614187;
    std::array<double, 4> place{};
    double step = 1;
    for (double& x : place) {
        step /= kRoot;
        const double value = 0.5 + step * (i + 1);
        x = value - std::floor(value);
    }
    return place;
}

/// A point of a polygon, and by how much larger its surroundings are than those of others: evenly in the square is not evenly in a
/// quad that is no parallelogram.
struct Place {
    dvec3 point;
    double weight;
};

dvec3 inTriangle(const dvec3& a, const dvec3& b, const dvec3& c, double s, double t) {
    return s + t > 1 ? a + (1 - s) * (b - a) + (1 - t) * (c - a) : a + s * (b - a) + t * (c - a); // the square folded
}

Place placeIn(const Polygon& p, double s, double t) {
    if (p.count() == 3) return {inTriangle(p[0], p[1], p[2], s, t), 1};
    if (p.count() == 4) {
        const dvec3 alongS = glm::mix(p[1] - p[0], p[2] - p[3], t), alongT = glm::mix(p[3] - p[0], p[2] - p[1], s);
        return {glm::mix(glm::mix(p[0], p[1], s), glm::mix(p[3], p[2], s), t), glm::length(glm::cross(alongS, alongT))};
    }
    // As many strips of the square as there are triangles in a fan, each counted by its triangle's area.
    const auto triangles = static_cast<double>(p.count() - 2);
    const std::size_t i = std::min(p.count() - 3, static_cast<std::size_t>(s * triangles));
    return {inTriangle(p[0], p[i + 1], p[i + 2], s * triangles - static_cast<double>(i), t),
            triangles * glm::length(glm::cross(p[i + 1] - p[0], p[i + 2] - p[0]))};
}

/// What a line between two points carries, up to a factor.
double kernel(const Patch& a, const Patch& b, const dvec3& from, const dvec3& to) {
    const dvec3 way = to - from;
    const double square = glm::dot(way, way);
    return std::max(0.0, glm::dot(a.normal, way)) * std::max(0.0, -glm::dot(b.normal, way)) / (square * square);
}

} // namespace

VisibleExchange visibleExchange(const Patch& a, const Patch& b, const Occlusion& occlusion, const Blockers& known,
                                double linesInAll) {
    using Kind = VisibleExchange::Kind;
    if (isBehind(a.plane(), b.polygon, 0) || isBehind(b.plane(), a.polygon, 0)) return {};
    const Blockers blockers = known.empty() ? known : occlusion.between(a.polygon, b.polygon, &known);
    if (!blockers.empty() && occlusion.hideAll(blockers, a.polygon, b.polygon)) return {Kind::hidden, 0, 0};
    const Exchange whole = unoccludedExchange(a.polygon, b.polygon);
    if (whole.area <= 0) return {};
    if (blockers.empty()) return {Kind::full, whole.area, whole.error};
    const double share = whole.area / std::min(a.area, b.area);
    const int lines = static_cast<int>(std::clamp(std::ceil(linesInAll * share), kFewestLines, kMostLines));
    double free = 0, all = 0, squares = 0;
    for (int i = 0; i < lines; ++i) {
        const auto x = evenly(i);
        const Place from = placeIn(a.polygon, x[0], x[1]), to = placeIn(b.polygon, x[2], x[3]);
        const double weight = from.weight * to.weight * kernel(a, b, from.point, to.point);
        all += weight;
        squares += weight * weight;
        if (weight > 0 && !occlusion.hide(blockers, from.point, to.point)) free += weight;
    }
    if (!(all > 0)) return {Kind::partial, 0, whole.area};
    const double seen = free / all;
    // A mean of weighted ones and zeros; at most a half wide even where all lines have met the same.
    const double counted = all * all / squares; // as many lines of equal weight would scatter as much
    const double scatter = std::max(seen * (1 - seen), 0.25 / counted);
    return {Kind::partial, seen * whole.area, std::sqrt(scatter / counted) * whole.area + whole.error};
}

} // namespace shadowlab::radiosity
