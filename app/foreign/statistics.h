// Two figures of many values: their middle, and how alike two rows of them are.
// SPDX-License-Identifier: MIT
#pragma once
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <vector>

namespace shadowlab::foreign {

/// The median, of an even number the upper one, by what `projection` makes of each. There must be at least one.
template <class T, class Projection = std::identity>
T middleOf(std::vector<T> values, Projection projection = {}) {
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::ranges::nth_element(values, middle, {}, projection);
    return *middle;
}

/// Pearson's correlation of pairs of numbers.
class Correlation {
public:
    void add(double a, double b) { ++count_, a_ += a, b_ += b, aa_ += a * a, bb_ += b * b, ab_ += a * b; }
    /// -1 to 1; 0 where one of the two does not vary.
    [[nodiscard]] double value() const {
        constexpr double kRounding = 1e-12; // of sums of numbers up to 1
        const double varianceA = aa_ - a_ * a_ / count_, varianceB = bb_ - b_ * b_ / count_;
        if (!(varianceA > kRounding && varianceB > kRounding)) return 0;
        return (ab_ - a_ * b_ / count_) / std::sqrt(varianceA * varianceB);
    }

private:
    double count_ = 0, a_ = 0, b_ = 0, aa_ = 0, bb_ = 0, ab_ = 0;
};

} // namespace shadowlab::foreign
