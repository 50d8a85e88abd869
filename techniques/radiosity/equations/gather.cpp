// SPDX-License-Identifier: MIT
#include "techniques/radiosity/equations/gather.h"

#include <array>
#include <cstring>

#include "techniques/radiosity/exchange/exchange_matrix.h"

namespace shadowlab::radiosity {

namespace {

/// Two doubles in one register of 128 bits, added and multiplied at once. Written explicitly (an extension of g++ and clang),
/// since the compiler's own vectorisation of this loop spends more time shuffling than computing.
using Pair = double __attribute__((vector_size(16)));

Pair pairAt(const double* numbers) {
    Pair pair;
    std::memcpy(&pair, numbers, sizeof pair);
    return pair;
}

/// Each sum is accumulated in so many partial sums: additions need not wait for each other, and the rounding error is that of a
/// sum of a fourth of the length.
constexpr std::size_t kLanes = 4;

struct Lanes {
    Pair first{}, second{};
    void add(Pair firstFactor, Pair secondFactor, const double* others) {
        first += firstFactor * pairAt(others);
        second += secondFactor * pairAt(others + 2);
    }
    /// The remaining numbers, fewer than four.
    void addRest(const double* factors, const double* others, std::size_t count) {
        if (count > 0) first[0] += factors[0] * others[0];
        if (count > 1) first[1] += factors[1] * others[1];
        if (count > 2) second[0] += factors[2] * others[2];
    }
    [[nodiscard]] double total() const { return (first[0] + first[1]) + (second[0] + second[1]); }
};

} // namespace

std::vector<dvec3> gathered(const ExchangeMatrix& exchange, std::span<const double> areas,
                            std::span<const dvec3> radiosity) {
    const std::size_t size = exchange.size(), whole = size / kLanes * kLanes;
    std::array<std::vector<double>, 3> colours; // each colour contiguous in memory
    for (int c = 0; c < 3; ++c) {
        colours[c].reserve(size);
        for (const dvec3& value : radiosity)
            colours[c].push_back(value[c]);
    }
    std::vector<dvec3> irradiance(size);
    forRows(size, [&](std::size_t i) {
        const double* const row = exchange.row(i).data();
        const double *const red = colours[0].data(), *const green = colours[1].data(), *const blue = colours[2].data();
        Lanes reds, greens, blues;
        for (std::size_t j = 0; j < whole; j += kLanes) {
            const Pair first = pairAt(row + j), second = pairAt(row + j + 2);
            reds.add(first, second, red + j);
            greens.add(first, second, green + j);
            blues.add(first, second, blue + j);
        }
        reds.addRest(row + whole, red + whole, size - whole);
        greens.addRest(row + whole, green + whole, size - whole);
        blues.addRest(row + whole, blue + whole, size - whole);
        irradiance[i] = dvec3(reds.total(), greens.total(), blues.total()) / areas[i];
    });
    return irradiance;
}

double gatherRounding(std::size_t patches) {
    // One product, the additions in a lane, two additions of lanes, one division; and four more for factors that a caller
    // multiplies by before and after (reflectance, step length).
    const double roundings = static_cast<double>((patches + kLanes - 1) / kLanes) + 8;
    return roundings * kRoundingUnit / (1 - roundings * kRoundingUnit);
}

} // namespace shadowlab::radiosity
