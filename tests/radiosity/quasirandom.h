// Points that fill the unit square of four dimensions evenly: an integration rule that shares no code with the technique's own.
// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <cmath>

namespace shadowlab::testing {

/// Point i of a sequence that may be stopped anywhere: multiples of powers of the root of x^5 = x + 1 (M. Roberts, "The
/// Unreasonable Effectiveness of Quasirandom Sequences", 2018).
inline std::array<double, 4> quasirandom4(int i) {
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

} // namespace shadowlab::testing
