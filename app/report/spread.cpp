// SPDX-License-Identifier: MIT
#include "app/report/spread.h"

#include <algorithm>
#include <cmath>

#include "app/judge/metrics/frame_times.h"

namespace shadowlab::report {

namespace {

/// The largest k with P(fewer than k of n values lie below the median) <= 2.5 %: the k-th value from either end bounds the
/// interval. 0: there is none.
std::size_t intervalRank(std::size_t n) {
    // ln of n over i, by the gamma function: 2^-n alone would underflow.
    const auto logTerm = [n](std::size_t i) {
        const auto nn = static_cast<double>(n), ii = static_cast<double>(i);
        return std::lgamma(nn + 1) - std::lgamma(ii + 1) - std::lgamma(nn - ii + 1) - nn * std::log(2.0);
    };
    double below = 0;
    std::size_t k = 0;
    while (k < n && below + std::exp(logTerm(k)) <= 0.025)
        below += std::exp(logTerm(k++));
    return k;
}

} // namespace

Spread spreadOf(std::vector<double> values) {
    if (values.empty()) return {};
    std::ranges::sort(values);
    const std::size_t n = values.size(), rank = std::max<std::size_t>(intervalRank(n), 1);
    const auto last = static_cast<std::size_t>(std::ceil(0.95 * static_cast<double>(n))) - 1;
    return {judge::median(values), values[rank - 1], values[n - rank], values[last]};
}

std::optional<double> powerOf(std::span<const double> x, std::span<const double> y) {
    std::vector<dvec2> logs;
    for (std::size_t i = 0; i < x.size(); ++i)
        if (x[i] > 0 && y[i] > 0) logs.emplace_back(std::log(x[i]), std::log(y[i]));
    if (logs.size() < 2) return std::nullopt;
    dvec2 mean(0);
    for (const dvec2& p : logs)
        mean += p / static_cast<double>(logs.size());
    double along = 0, both = 0;
    for (const dvec2& p : logs) {
        along += (p.x - mean.x) * (p.x - mean.x);
        both += (p.x - mean.x) * (p.y - mean.y);
    }
    if (!(along > 0)) return std::nullopt;
    return both / along;
}

} // namespace shadowlab::report
