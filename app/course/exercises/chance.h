// The random choices of an exercise: the same for the same seed, on every machine.
// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "techniques/foundation/base/mixed_bits.h"
#include "techniques/foundation/base/random_bits.h"

namespace shadowlab::course {

class Chance {
public:
    explicit Chance(std::uint64_t seed) : bits_(mixedBits(seed) + kGoldenBits) {}

    /// A whole number from `least` to `most`.
    int between(int least, int most) {
        return least + static_cast<int>(bits_.below(static_cast<std::uint64_t>(most - least + 1)));
    }
    bool coin() { return between(0, 1) == 1; }
    int sign() { return coin() ? 1 : -1; }
    template <typename Value>
    const Value& oneOf(const std::vector<Value>& values) {
        return values[static_cast<std::size_t>(between(0, static_cast<int>(values.size()) - 1))];
    }
    /// Fisher and Yates's shuffle.
    template <typename Value>
    void shuffle(std::vector<Value>& values) {
        for (std::size_t i = values.size(); i > 1; --i)
            std::swap(values[i - 1], values[static_cast<std::size_t>(between(0, static_cast<int>(i) - 1))]);
    }

private:
    RandomBits bits_;
};

} // namespace shadowlab::course
