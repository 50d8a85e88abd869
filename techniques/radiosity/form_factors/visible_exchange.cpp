// SPDX-License-Identifier: MIT
#include "techniques/radiosity/form_factors/visible_exchange.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "techniques/radiosity/patches/polygon_samples.h"

namespace shadowlab::radiosity {

namespace {

// Fewer lines than this tell next to nothing; more than a few thousand no more than a patch is worth.
constexpr double kFewestLines = 8, kMostLines = 4096;

/// What a line between two points carries, up to a factor.
double kernel(const Patch& a, const Patch& b, const dvec3& from, const dvec3& to) {
    const dvec3 way = to - from;
    const double square = glm::dot(way, way);
    return std::max(0.0, glm::dot(a.normal, way)) * std::max(0.0, -glm::dot(b.normal, way)) / (square * square);
}

// To what share of itself the exchange with nothing in between is found; where lines are to say how much of it is left, they err
// by a hundredth at best.
constexpr double kWhole = 1e-7, kInPart = 1e-4;

} // namespace

VisibleExchange visibleExchange(const Patch& a, const Patch& b, const Occlusion& occlusion, const Blockers& known,
                                double linesPerPatch) {
    using Kind = VisibleExchange::Kind;
    if (isBehind(a.plane(), b.polygon, 0) || isBehind(b.plane(), a.polygon, 0)) return {};
    Blockers blockers = known.empty() ? known : occlusion.between(a.polygon, b.polygon, &known);
    if (!blockers.empty() && occlusion.blocksAll(blockers, a.polygon, b.polygon)) return {Kind::hidden, 0, 0};
    const Exchange whole = unoccludedExchange(a.polygon, b.polygon, blockers.empty() ? kWhole : kInPart);
    if (whole.area <= 0) return {};
    if (blockers.empty()) return {Kind::full, whole.area, whole.error};
    const double share = whole.area / std::min(a.area, b.area);
    const int lines = static_cast<int>(std::clamp(std::ceil(linesPerPatch * share), kFewestLines, kMostLines));
    double free = 0, all = 0, squares = 0;
    for (int i = 0; i < lines; ++i) {
        const auto x = hammersley4(i, lines);
        const Place from = placeIn(a.polygon, x[0], x[1]), to = placeIn(b.polygon, x[2], x[3]);
        const double weight = from.weight * to.weight * kernel(a, b, from.point, to.point);
        all += weight;
        squares += weight * weight;
        if (!(weight > 0)) continue;
        const auto firstBlocker = occlusion.firstBlocker(blockers, from.point, to.point);
        if (firstBlocker == blockers.end())
            free += weight;
        else
            std::swap(blockers[static_cast<std::size_t>(firstBlocker - blockers.begin())],
                      blockers.front()); // the next line may meet it, too
    }
    if (!(all > 0)) return {Kind::partial, 0, whole.area};
    const double seen = free / all;
    // A mean of weighted ones and zeros; at most a half wide even where all lines have met the same.
    const double counted = all * all / squares; // as many lines of equal weight would scatter as much
    const double scatter = std::max(seen * (1 - seen), 0.25 / counted);
    return {Kind::partial, seen * whole.area, std::sqrt(scatter / counted) * whole.area + whole.error};
}

} // namespace shadowlab::radiosity
