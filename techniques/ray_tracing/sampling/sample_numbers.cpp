// SPDX-License-Identifier: MIT
#include "techniques/ray_tracing/sampling/sample_numbers.h"

#include <algorithm>
#include <cmath>

#include "techniques/foundation/base/mixed_bits.h"
#include "techniques/foundation/math/random_pair.h"

namespace shadowlab::ray_tracing {

namespace {

double fraction(std::uint32_t bits) { return bits * 0x1p-32; }

/// A random permutation of 0 ... count - 1 that belongs to the key, applied to `place`: four rounds that each permute the numbers
/// below a power of two, repeated while the result is not below `count` (cycle walking, Black and Rogaway 2002). Each round can
/// be undone by a multiplication and two shifts, so no two places map to the same number.
std::uint32_t shuffled(std::uint32_t place, std::uint32_t count, std::uint64_t key) {
    if (count <= 1) return 0;
    std::uint32_t bits = 1;
    while (bits < 32 && (1u << bits) < count)
        ++bits;
    const std::uint32_t mask = bits == 32 ? ~0u : (1u << bits) - 1;
    const std::uint32_t half = std::max(1u, bits / 2);
    do {
        for (std::uint32_t round = 0; round < 4; ++round) {
            const std::uint64_t random = mixedBits(key + round);
            place = (place + static_cast<std::uint32_t>(random >> 32)) & mask;
            place = (place * (static_cast<std::uint32_t>(random) | 1u)) & mask; // odd: has an inverse
            place ^= place >> half;
        }
    } while (place >= count);
    return place;
}

/// A point of cell `cell`, of `count` cells of equal area that fill the unit square in rows: about as many rows as columns, so
/// that any count is possible. `within`: the position in the cell, (0.5, 0.5) is its centre.
dvec2 inCell(int cell, int count, dvec2 within) {
    const int rows = std::max(1, static_cast<int>(std::lround(std::sqrt(count))));
    const int row = static_cast<int>((static_cast<std::int64_t>(cell + 1) * rows - 1) / count);
    const int first = static_cast<int>(static_cast<std::int64_t>(row) * count / rows);
    const int columns = static_cast<int>(static_cast<std::int64_t>(row + 1) * count / rows) - first;
    return {(cell - first + within.x) / columns, (first + within.y * columns) / count};
}

std::uint32_t reversed(std::uint32_t x) {
    x = (x >> 16) | (x << 16);
    x = ((x & 0xff00ff00u) >> 8) | ((x & 0x00ff00ffu) << 8);
    x = ((x & 0xf0f0f0f0u) >> 4) | ((x & 0x0f0f0f0fu) << 4);
    x = ((x & 0xccccccccu) >> 2) | ((x & 0x33333333u) << 2);
    return ((x & 0xaaaaaaaau) >> 1) | ((x & 0x55555555u) << 1);
}

/// Owen scrambling: every half, quarter, eighth ... of the interval is swapped with its neighbour or not, at random. Every step
/// makes a bit depend only on lower ones, in reversed order on higher ones. B. Burley, "Practical Hash-based Owen Scrambling",
/// Journal of Computer Graphics Techniques 2020, after Laine and Karras 2011.
std::uint32_t scrambled(std::uint32_t x, std::uint32_t seed) {
    x = reversed(x);
    x += seed;
    x ^= x * 0x6c50b47cu;
    x ^= x * 0xb82f1e52u;
    x ^= x * 0xc7afe638u;
    x ^= x * 0x8d22f6e6u;
    return reversed(x);
}

/// The second coordinate of the Sobol' sequence (1967): its direction numbers are the rows of Pascal's triangle modulo 2.
std::uint32_t secondOfSobol(std::uint32_t index) {
    std::uint32_t result = 0;
    for (std::uint32_t direction = 0x80000000u; index != 0; index >>= 1, direction ^= direction >> 1)
        if (index & 1u) result ^= direction;
    return result;
}

/// Point `index` of a sequence whose first 2^n points fill the square evenly, for every n.
dvec2 evenPoint(std::uint32_t index, std::uint64_t key) {
    const std::uint64_t order = mixedBits(key), where = mixedBits(key + 1);
    // A different order in each dimension.
    const std::uint32_t place = scrambled(index, static_cast<std::uint32_t>(order));
    return {fraction(scrambled(reversed(place), static_cast<std::uint32_t>(where))),
            fraction(scrambled(secondOfSobol(place), static_cast<std::uint32_t>(where >> 32)))};
}

} // namespace

SampleNumbers::SampleNumbers(const SamplePattern& pattern, ivec2 pixel, std::uint32_t sample)
    : pattern_(pattern),
      pixelKey_(mixedBits(mixedBits(pixelKey(pixel)) + static_cast<std::uint32_t>(pattern.seed))),
      sample_(sample) {
    if (pattern.spread == SamplePattern::Spread::regular) pixelKey_ = mixedBits(static_cast<std::uint32_t>(pattern.seed));
}

std::uint64_t SampleNumbers::dimensionOf(Purpose purpose, std::uint64_t place) const {
    return mixedBits(pixelKey_ + mixedBits(place * 8 + static_cast<std::uint32_t>(purpose)));
}

dvec2 SampleNumbers::pair(Purpose purpose, std::uint64_t place, std::uint32_t attempt) const {
    using enum SamplePattern::Spread;
    const std::uint64_t dimension = dimensionOf(purpose, place);
    const dvec2 free = randomPair(dimension + mixedBits(sample_ + (static_cast<std::uint64_t>(attempt + 1) << 32)));
    if (attempt > 0 || pattern_.spread == random) return free;
    if (pattern_.spread == lowDiscrepancy) return evenPoint(sample_, dimension);
    const double amount = pattern_.spread == regular ? 0.0 : pattern_.jitter;
    return inCell(cellIn(dimension), pattern_.count, 0.5 + amount * (free - 0.5));
}

/// The sample's cell, of `count` equal ones.
int SampleNumbers::cellIn(std::uint64_t dimension) const {
    const auto count = static_cast<std::uint32_t>(pattern_.count);
    return static_cast<int>(shuffled(sample_ % count, count, dimension));
}

std::optional<std::array<dvec2, 2>> SampleNumbers::cell(Purpose purpose, std::uint64_t place) const {
    using enum SamplePattern::Spread;
    if (pattern_.spread != jittered && pattern_.spread != regular) return std::nullopt;
    const int cell = cellIn(dimensionOf(purpose, place));
    return std::array{inCell(cell, pattern_.count, dvec2(0)), inCell(cell, pattern_.count, dvec2(1))};
}

double SampleNumbers::one(Purpose purpose) const {
    using enum SamplePattern::Spread;
    const std::uint64_t dimension = dimensionOf(purpose, 0);
    const double free = randomPair(dimension + mixedBits(sample_)).x;
    if (pattern_.spread == random) return free;
    if (pattern_.spread == lowDiscrepancy) return evenPoint(sample_, dimension).x;
    const auto count = static_cast<std::uint32_t>(pattern_.count);
    const double amount = pattern_.spread == regular ? 0.0 : pattern_.jitter;
    return (shuffled(sample_ % count, count, dimension) + 0.5 + amount * (free - 0.5)) / pattern_.count;
}

} // namespace shadowlab::ray_tracing
