// A logarithmic axis between two places of a sheet.
// SPDX-License-Identifier: MIT
#pragma once
#include <span>
#include <string>
#include <vector>

namespace shadowlab::report {

/// Its ends are 1, 2 or 5 times a power of ten, chosen so that all values lie within, and it spans one decade at least.
class LogAxis {
public:
    /// `values`: those that are finite and above zero count; if there is none, the axis is from 0.1 to 1. `from` and `to` are the
    /// places of its two ends, in pixels of the sheet.
    LogAxis(std::span<const double> values, double from, double to);

    /// Where a value belongs. What lies outside of the axis, as zero does, is placed at its end.
    [[nodiscard]] double place(double value) const;

    struct Tick {
        double value;
        std::string text; ///< "0.02"
    };
    /// 1, 2 and 5 of every decade; powers of ten alone where `room` pixels would not lie between those; of these only every
    /// second, third ... where there are too many.
    [[nodiscard]] std::vector<Tick> ticks(double room) const;
    /// 1 to 9 of every decade, for fine lines; powers of ten alone where those would be a grey area.
    [[nodiscard]] std::vector<double> grid() const;

    [[nodiscard]] double low() const { return stepValue(first_); }
    [[nodiscard]] double high() const { return stepValue(last_); }

private:
    static double stepValue(int step);
    [[nodiscard]] double pixelsPerDecade() const;

    int first_ = -3, last_ = 0; ///< steps: 0 is 1, 1 is 2, 2 is 5, 3 is 10 ...
    double from_, to_;
};

/// With three digits that count: "0.0123", "12.3", "1230". "-" for what is no number.
std::string threeDigits(double value);

} // namespace shadowlab::report
