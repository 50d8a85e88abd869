// Sets that are joined, two at a time.
// SPDX-License-Identifier: MIT
#pragma once
#include <algorithm>
#include <cstdint>
#include <numeric>
#include <vector>

namespace shadowlab {

/// Of the numbers 0 to count - 1, at first each by itself. A set is named by its least number. Union-find with path halving (Tarjan and
/// van Leeuwen, "Worst-Case Analysis of Set Union Algorithms", 1984).
class DisjointSets {
public:
    explicit DisjointSets(std::size_t count) : parents_(count) { std::iota(parents_.begin(), parents_.end(), 0u); }
    [[nodiscard]] std::uint32_t nameOf(std::uint32_t number) {
        while (parents_[number] != number)
            number = parents_[number] = parents_[parents_[number]];
        return number;
    }
    /// False if they were in one set already.
    bool join(std::uint32_t one, std::uint32_t other) {
        const std::uint32_t a = nameOf(one), b = nameOf(other);
        parents_[std::max(a, b)] = std::min(a, b);
        return a != b;
    }
    /// The name of each number's set.
    [[nodiscard]] std::vector<std::uint32_t> names() {
        for (std::uint32_t number = 0; number < parents_.size(); ++number)
            parents_[number] = nameOf(number);
        return parents_;
    }

private:
    std::vector<std::uint32_t> parents_;
};

} // namespace shadowlab
