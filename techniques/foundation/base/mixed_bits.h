// Hashes: every bit of what goes in changes about half of the bits that come out.
// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>

namespace shadowlab {

/// 2^64 divided by the golden ratio: multiples of it lie far apart (D. Knuth, "The Art of Computer Programming" 3, 6.4).
constexpr std::uint64_t kGoldenBits = 0x9e3779b97f4a7c15u;

/// A random number that belongs to the key. D. Stafford's constants for the last step of MurmurHash3, 2011, as in Steele, Lea and
/// Flood's SplitMix64, 2014.
constexpr std::uint64_t mixedBits(std::uint64_t key) {
    key += kGoldenBits;
    key = (key ^ (key >> 30)) * 0xbf58476d1ce4e5b9u;
    key = (key ^ (key >> 27)) * 0x94d049bb133111ebu;
    return key ^ (key >> 31);
}

/// The hash of some words and one more, for hash tables: quicker, and not as thorough.
constexpr std::uint64_t hashedWith(std::uint64_t hash, std::uint64_t word) {
    hash = (hash ^ word) * kGoldenBits;
    return hash ^ (hash >> 32);
}

} // namespace shadowlab
