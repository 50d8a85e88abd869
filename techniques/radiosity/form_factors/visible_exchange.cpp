// SPDX-License-Identifier: MIT
#include "techniques/radiosity/form_factors/visible_exchange.h"

#include <algorithm>
#include <cmath>
#include <utility>


namespace shadowlab::radiosity {

namespace {

// With fewer lines the estimate is useless; a few thousand are as exact as a patch deserves.
constexpr double kFewestLines = 8, kMostLines = 4096;

// Relative tolerance of the unoccluded exchange. Where sampling decides how much of it is visible, the sampling error is a
// hundredth at best, so the second is enough.
constexpr double kWhole = 1e-7, kInPart = 1e-4;

} // namespace

double exchangeKernel(const Patch& a, const Patch& b, const dvec3& from, const dvec3& to) {
    const dvec3 way = to - from;
    const double square = glm::dot(way, way);
    return std::max(0.0, glm::dot(a.normal, way)) * std::max(0.0, -glm::dot(b.normal, way)) / (square * square);
}

int linesBetween(const Patch& a, const Patch& b, double exchangeArea, double linesPerPatch) {
    const double share = exchangeArea / std::min(a.area, b.area);
    return static_cast<int>(std::clamp(std::ceil(linesPerPatch * share), kFewestLines, kMostLines));
}

VisibleExchange visibleExchange(const Patch& a, const Patch& b, const Occlusion& occlusion, const Blockers& known,
                                double linesPerPatch) {
    using Kind = VisibleExchange::Kind;
    if (isBehind(a.plane(), b.polygon, 0) || isBehind(b.plane(), a.polygon, 0)) return {};
    Blockers blockers = known.empty() ? known : occlusion.between(a.polygon, b.polygon, &known);
    if (!blockers.empty() && occlusion.blocksAll(blockers, a.polygon, b.polygon)) return {Kind::hidden, 0, 0};
    const Exchange whole = unoccludedExchange(a.polygon, b.polygon, blockers.empty() ? kWhole : kInPart);
    if (whole.area <= 0) return {};
    if (blockers.empty()) return {Kind::full, whole.area, whole.error};
    double free = 0, all = 0, squares = 0;
    forLinesBetween(a, b, linesBetween(a, b, whole.area, linesPerPatch), [&](const dvec3& from, const dvec3& to, double weight) {
        all += weight;
        squares += weight * weight;
        if (!(weight > 0)) return;
        const auto firstBlocker = occlusion.firstBlocker(blockers, from, to);
        if (firstBlocker == blockers.end())
            free += weight;
        else
            // Tested first for the next line, which it probably blocks, too.
            std::swap(blockers[static_cast<std::size_t>(firstBlocker - blockers.begin())], blockers.front());
    });
    if (!(all > 0)) return {Kind::partial, 0, whole.area};
    const double seen = free / all;
    // The standard error of a weighted mean of zeros and ones; not below that of one half, because all lines may agree by chance.
    const double counted = all * all / squares; // the effective number of samples (Kish)
    const double scatter = std::max(seen * (1 - seen), 0.25 / counted);
    return {Kind::partial, seen * whole.area, std::sqrt(scatter / counted) * whole.area + whole.error};
}

} // namespace shadowlab::radiosity
