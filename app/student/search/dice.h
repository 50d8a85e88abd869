// Random numbers that are the same on every machine: std::mt19937 is, but its distributions are not.
// SPDX-License-Identifier: MIT
#pragma once
#include <cmath>
#include <cstdint>

#include "techniques/foundation/base/mixed_bits.h"
#include "techniques/foundation/math/types.h"

namespace shadowlab::student {

class Dice {
public:
    Dice(std::uint64_t seed, std::uint64_t number) : key_(hashedWith(mixedBits(seed), number)) {}

    /// 0 ... count - 1.
    int below(int count) { return static_cast<int>(next() % static_cast<std::uint64_t>(count)); }
    bool chance(double share) { return unit() < share; }
    /// From `low` to `high`, in steps of a centimetre (or of a hundredth of what it is).
    double real(double low, double high) { return std::round((low + (high - low) * unit()) * 100) / 100; }
    dvec3 place(const dvec3& low, const dvec3& high) {
        const double x = real(low.x, high.x), y = real(low.y, high.y); // in this order, whatever the compiler
        return {x, y, real(low.z, high.z)};
    }

private:
    std::uint64_t next() { return mixedBits(key_ + counter_++ * kGoldenBits); }
    double unit() { return static_cast<double>(next() >> 11) * 0x1p-53; }

    std::uint64_t key_, counter_ = 0;
};

} // namespace shadowlab::student
