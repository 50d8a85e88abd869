// A number for a sequence of bytes: equal for equal bytes, on every machine, and very rarely for others.
// Source: Fowler, Noll and Vo, FNV-1a with 64 bits, 1991.
// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <cstdint>

namespace shadowlab {

constexpr std::uint64_t kFnvBasis = 14695981039346656037ull; ///< of no bytes

/// Of the bytes before, whose number is `hash`, and these.
inline std::uint64_t fnv(const void* bytes, std::size_t count, std::uint64_t hash = kFnvBasis) {
    constexpr std::uint64_t kPrime = 1099511628211ull;
    const auto* byte = static_cast<const unsigned char*>(bytes);
    for (std::size_t i = 0; i < count; ++i)
        hash = (hash ^ byte[i]) * kPrime;
    return hash;
}

} // namespace shadowlab
