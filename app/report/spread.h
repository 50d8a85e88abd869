// Statistics of times: what lies in the middle, where the middle may lie, and how quantities grow.
// SPDX-License-Identifier: MIT
#pragma once
#include <optional>
#include <span>
#include <vector>

#include "app/report/results.h"

namespace shadowlab::report {

/// The median with its 95 % confidence interval, and the 95th percentile. The interval is that of order statistics, which holds
/// for any distribution: of n values the number below the true median is binomial with p = 1/2. Fewer than six values cannot
/// promise 95 %: then it is from the least to the largest. All zero of no values.
Spread spreadOf(std::vector<double> values);

/// The power b of y ~ x^b, by least squares of the logarithms. None: fewer than two different positive x with positive y.
std::optional<double> powerOf(std::span<const double> x, std::span<const double> y);

} // namespace shadowlab::report
