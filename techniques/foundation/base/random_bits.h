// A stream of random numbers that is the same on every machine: std::mt19937 is, but its distributions are not.
// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>

#include "techniques/foundation/base/mixed_bits.h"

namespace shadowlab {

/// The hashes of a key and of what follows it in steps of kGoldenBits (Steele, Lea and Flood's SplitMix64, 2014).
class RandomBits {
public:
    explicit RandomBits(std::uint64_t key) : key_(key) {}

    /// 64 random bits.
    std::uint64_t next() {
        const std::uint64_t bits = mixedBits(key_);
        key_ += kGoldenBits;
        return bits;
    }
    /// 0 ... count - 1. The remainder of 64 bits is uneven by less than count in 2^64.
    std::uint64_t below(std::uint64_t count) { return next() % count; }

private:
    std::uint64_t key_;
};

} // namespace shadowlab
