// The random choices of a scene: the same for the same seed and number, on every machine.
// SPDX-License-Identifier: MIT
#pragma once
#include <cmath>
#include <cstdint>

#include "techniques/foundation/base/mixed_bits.h"
#include "techniques/foundation/base/random_bits.h"
#include "techniques/foundation/math/types.h"

namespace shadowlab::student {

class Dice {
public:
    Dice(std::uint64_t seed, std::uint64_t number) : bits_(hashedWith(mixedBits(seed), number)) {}

    /// 0 ... count - 1.
    int below(int count) { return static_cast<int>(bits_.below(static_cast<std::uint64_t>(count))); }
    bool chance(double share) { return unit() < share; }
    /// From `low` to `high`, in steps of a centimetre (or of a hundredth of what it is).
    double real(double low, double high) { return std::round((low + (high - low) * unit()) * 100) / 100; }
    dvec3 place(const dvec3& low, const dvec3& high) {
        const double x = real(low.x, high.x), y = real(low.y, high.y); // in this order, whatever the compiler
        return {x, y, real(low.z, high.z)};
    }

private:
    double unit() { return static_cast<double>(bits_.next() >> 11) * 0x1p-53; }

    RandomBits bits_;
};

} // namespace shadowlab::student
