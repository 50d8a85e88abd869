// SPDX-License-Identifier: MIT
#include "app/report/analysis.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdio>
#include <map>

#include "app/report/spread.h"

namespace shadowlab::report {

namespace {

bool competes(const Point& point) { return point.costs && !point.isYardstick && point.errors.served >= 1; }

bool isBetter(const Point& a, const Point& b) {
    const double costA = a.costs->frame.median, costB = b.costs->frame.median;
    const double errorA = a.errors.shown(), errorB = b.errors.shown();
    return costA <= costB && errorA <= errorB && (costA < costB || errorA < errorB);
}

std::string milliseconds(double value) {
    std::array<char, 32> text{};
    const auto [end, error] = std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::fixed,
                                            value < 10 ? 2 : 1); // independent of the locale
    return (error == std::errc{} ? std::string(text.data(), end) : "?") + " ms";
}

std::string percent(double share) {
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), "%.0f %%", 100 * share);
    return text.data();
}

std::string countersOf(const Errors& errors) {
    std::string text;
    for (const Errors::Counter& counter : errors.counters) {
        std::array<char, 160> one{};
        if (counter.of > 0)
            std::snprintf(one.data(), one.size(), "%s %.0f of %.0f", counter.id.c_str(), counter.built, counter.of);
        else
            std::snprintf(one.data(), one.size(), "%s %.0f", counter.id.c_str(), counter.built);
        text += (text.empty() ? "" : ", ") + std::string(one.data());
    }
    return text;
}

/// The parts of a frame, the longest first: preparing, each pass, encoding. Passes are timed one by one, so that they add up to
/// more than the frame; they are given as shares of their sum.
std::string whereTimeGoes(const Point& point) {
    std::vector<Costs::Pass> parts = point.costs->passes;
    parts.push_back({"preparing", point.costs->prepare.median});
    parts.push_back({"encoding the picture", point.costs->encode.median});
    double sum = 0;
    for (const Costs::Pass& part : parts)
        sum += part.ms;
    std::ranges::stable_sort(parts, std::ranges::greater{}, &Costs::Pass::ms);
    std::string text;
    constexpr std::size_t kTold = 3;
    for (std::size_t i = 0; i < std::min(parts.size(), kTold) && sum > 0; ++i)
        text += (i ? ", " : "") + parts[i].id + " " + percent(parts[i].ms / sum);
    const std::string counters = countersOf(point.errors);
    return text + (counters.empty() ? "" : " (" + counters + ")");
}

std::optional<std::size_t> cheapest(const Group& group, bool exact) {
    std::optional<std::size_t> best;
    for (std::size_t i = 0; i < group.points.size(); ++i) {
        const Point& point = group.points[i];
        if (!competes(point) || point.errors.isExact() != exact) continue;
        if (!best || point.costs->frame.median < group.points[*best].costs->frame.median) best = i;
    }
    return best;
}

} // namespace

void markFront(Group& group) {
    for (Point& point : group.points)
        point.onFront = competes(point) && std::ranges::none_of(group.points, [&](const Point& other) {
                            return competes(other) && isBetter(other, point);
                        });
}

std::vector<Growth> growthOf(const Group& group) {
    std::vector<Growth> growths;
    std::map<std::pair<std::string, std::string>, std::vector<const Point*>> sweeps;
    for (const Point& point : group.points)
        if (point.costs && !point.key.varies.empty()) sweeps[{point.key.technique, point.key.sweep}].push_back(&point);
    for (const auto& [names, points] : sweeps) {
        std::vector<double> values, costs, errors;
        for (const Point* point : points) {
            values.push_back(point->key.value);
            costs.push_back(point->costs->frame.median);
            errors.push_back(point->errors.shown());
        }
        const std::optional<double> costPower = powerOf(values, costs);
        if (!costPower) continue;
        growths.push_back({names.first, names.second, points.front()->key.varies, std::ranges::min(values),
                           std::ranges::max(values), *costPower, powerOf(values, errors)});
    }
    return growths;
}

ExactAgainstInexact exactnessOf(const Group& group) {
    ExactAgainstInexact result{cheapest(group, true), cheapest(group, false), 0, 0, ""};
    if (!result.exact || !result.inexact) return result;
    const Point& exact = group.points[*result.exact];
    const Point& inexact = group.points[*result.inexact];
    result.frameRatio = exact.costs->frame.median / inexact.costs->frame.median;
    if (inexact.costs->shadow.median > 0)
        result.shadowRatio = exact.costs->shadow.median / inexact.costs->shadow.median;
    if (result.frameRatio > kMostRatio)
        result.why = exact.key.name() + ": " + milliseconds(exact.costs->frame.median) + ", of which " +
                     whereTimeGoes(exact) + "; " + inexact.key.name() + ": " +
                     milliseconds(inexact.costs->frame.median) + ", of which " + whereTimeGoes(inexact);
    return result;
}

void analyse(Group& group) {
    markFront(group);
    group.growth = growthOf(group);
    group.exactness = exactnessOf(group);
}

} // namespace shadowlab::report
