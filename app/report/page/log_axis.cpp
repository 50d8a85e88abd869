// SPDX-License-Identifier: MIT
#include "app/report/page/log_axis.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <optional>

namespace shadowlab::report {

namespace {

constexpr std::array kDigits{1, 2, 5};
constexpr int kSteps = static_cast<int>(kDigits.size()); ///< in a decade
constexpr double kAir = 1.05; ///< values keep this factor from the ends, so that no marker is drawn across the frame
constexpr double kFineDecade = 120; ///< pixels: in fewer, the lines of 8 and 9 are nearer than 6 pixels
constexpr int kMostZeros = 4;       ///< "0.00002" and "50000"; beyond it "2e-6"

int decadeOf(int step) { return step >= 0 ? step / kSteps : -((-step + kSteps - 1) / kSteps); }
int digitOf(int step) { return kDigits[static_cast<std::size_t>(step - kSteps * decadeOf(step))]; }

/// Written from its digits, so that no rounding shows.
std::string stepText(int step) {
    const int decade = decadeOf(step);
    const std::string digit = std::to_string(digitOf(step));
    if (std::abs(decade) > kMostZeros + (decade < 0)) return digit + "e" + std::to_string(decade);
    if (decade >= 0) return digit + std::string(static_cast<std::size_t>(decade), '0');
    return "0." + std::string(static_cast<std::size_t>(-decade - 1), '0') + digit;
}

} // namespace

double LogAxis::stepValue(int step) { return digitOf(step) * std::pow(10.0, decadeOf(step)); }

LogAxis::LogAxis(std::span<const double> values, double from, double to) : from_(from), to_(to) {
    std::optional<double> least, most;
    for (const double value : values) {
        if (!std::isfinite(value) || value < std::numeric_limits<double>::min()) continue;
        least = std::min(least.value_or(value), value);
        most = std::max(most.value_or(value), value);
    }
    if (!least) return;
    first_ = kSteps * static_cast<int>(std::floor(std::log10(*least))) + kSteps;
    while (stepValue(first_) > *least / kAir)
        --first_;
    last_ = kSteps * static_cast<int>(std::floor(std::log10(*most)));
    while (stepValue(last_) < *most * kAir)
        ++last_;
    for (bool up = true; last_ - first_ < kSteps; up = !up)
        up ? ++last_ : --first_;
}

double LogAxis::place(double value) const {
    const double within = std::clamp(value, low(), high());
    return from_ + (to_ - from_) * std::log10(within / low()) / std::log10(high() / low());
}

double LogAxis::pixelsPerDecade() const { return std::abs(to_ - from_) * kSteps / (last_ - first_); }

std::vector<LogAxis::Tick> LogAxis::ticks(double room) const {
    // From 1 to 2 is the shortest way between two of them, as from 5 to 10.
    const bool all = pixelsPerDecade() * std::log10(2.0) >= room;
    const int every = all ? 1 : kSteps * std::max(1, static_cast<int>(std::ceil(room / pixelsPerDecade())));
    std::vector<Tick> ticks;
    for (int step = first_; step <= last_; ++step)
        if (step % every == 0) ticks.push_back({stepValue(step), stepText(step)});
    return ticks;
}

std::vector<double> LogAxis::grid() const {
    std::vector<double> values;
    const int finest = pixelsPerDecade() >= kFineDecade ? 9 : 1;
    for (int decade = decadeOf(first_); decade <= decadeOf(last_); ++decade)
        for (int digit = 1; digit <= finest; ++digit)
            if (const double value = digit * std::pow(10.0, decade); value >= low() && value <= high())
                values.push_back(value);
    return values;
}

std::string threeDigits(double value) {
    if (!std::isfinite(value)) return "-";
    std::array<char, 400> text{};
    constexpr double kWhole = 100; // from here on no digit behind the point counts
    const bool isWhole = std::abs(value) >= kWhole && std::abs(value) < 1e9;
    const auto result =
        isWhole ? std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::fixed, 0)
                : std::to_chars(text.data(), text.data() + text.size(), value + 0.0, std::chars_format::general, 3);
    return {text.data(), result.ptr};
}

} // namespace shadowlab::report
