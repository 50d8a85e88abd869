// Pairs of random numbers that belong to a key: the same in whatever order, and on however many threads, they are asked for.
// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>

#include "techniques/foundation/base/mixed_bits.h"
#include "techniques/foundation/math/types.h"

namespace shadowlab {

/// A key of its own for each pixel.
inline std::uint64_t pixelKey(ivec2 pixel) {
    return static_cast<std::uint32_t>(pixel.x) | (static_cast<std::uint64_t>(static_cast<std::uint32_t>(pixel.y)) << 32);
}

/// Two pseudo-random numbers in [0, 1), multiples of 2^-32.
inline dvec2 randomPair(std::uint64_t key) {
    const std::uint64_t bits = mixedBits(key);
    return dvec2(static_cast<double>(bits & 0xffffffffu), static_cast<double>(bits >> 32)) * 0x1p-32;
}

} // namespace shadowlab
