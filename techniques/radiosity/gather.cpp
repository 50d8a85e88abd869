// SPDX-License-Identifier: MIT
#include "techniques/radiosity/gather.h"

#include <array>

#include "techniques/radiosity/row_pieces.h"

namespace shadowlab::radiosity {

namespace {

/// A sum is kept as so many sums side by side: the processor need not wait for one addition to begin the next, and rounding
/// is that of a sum of a fourth of the length.
constexpr std::size_t kLanes = 4;

double total(const std::array<double, kLanes>& lanes) { return (lanes[0] + lanes[1]) + (lanes[2] + lanes[3]); }

} // namespace

std::vector<dvec3> gathered(const ExchangeMatrix& exchange, std::span<const double> areas,
                            std::span<const dvec3> radiosity) {
    const std::size_t size = exchange.size(), whole = size / kLanes * kLanes;
    std::array<std::vector<double>, 3> colours; // one after the other, as the processor likes to multiply them
    for (int c = 0; c < 3; ++c) {
        colours[c].reserve(size);
        for (const dvec3& value : radiosity)
            colours[c].push_back(value[c]);
    }
    std::vector<dvec3> irradiance(size);
    forRows(size, [&](std::size_t i) {
        const double* const row = exchange.row(i).data();
        const double *const red = colours[0].data(), *const green = colours[1].data(), *const blue = colours[2].data();
        std::array<double, kLanes> reds{}, greens{}, blues{};
        for (std::size_t j = 0; j < whole; j += kLanes)
            for (std::size_t lane = 0; lane < kLanes; ++lane) {
                reds[lane] += row[j + lane] * red[j + lane];
                greens[lane] += row[j + lane] * green[j + lane];
                blues[lane] += row[j + lane] * blue[j + lane];
            }
        for (std::size_t j = whole; j < size; ++j) {
            reds[j - whole] += row[j] * red[j];
            greens[j - whole] += row[j] * green[j];
            blues[j - whole] += row[j] * blue[j];
        }
        irradiance[i] = dvec3(total(reds), total(greens), total(blues)) / areas[i];
    });
    return irradiance;
}

double gatherRounding(std::size_t patches) {
    // One product, the additions of a lane, two of lanes, one division; and four for what a caller multiplies by before and
    // after (reflectance, a step length), so that nobody needs to count again.
    const double roundings = static_cast<double>((patches + kLanes - 1) / kLanes) + 8;
    return roundings * kRoundingUnit / (1 - roundings * kRoundingUnit);
}

} // namespace shadowlab::radiosity
