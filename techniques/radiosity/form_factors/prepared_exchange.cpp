// SPDX-License-Identifier: MIT
#include "techniques/radiosity/form_factors/prepared_exchange.h"

#include <algorithm>
#include <cmath>

#include "techniques/radiosity/room/closed_parts.h"

namespace shadowlab::radiosity {

namespace {

ExchangeMatrix partOfExchange(const ExchangeMatrix& all, std::span<const std::size_t> part) {
    ExchangeMatrix some(part.size());
    for (std::size_t i = 0; i < part.size(); ++i)
        for (std::size_t j = 0; j <= i; ++j)
            some.set(i, j, all(part[i], part[j]));
    return some;
}

/// Scales a closed part of the matrix until its rows sum to 1, and returns by how much that changed it; where that cannot be, it stays.
double scalePart(ExchangeMatrix& matrix, std::span<const double> areas, std::span<const std::size_t> part) {
    std::vector<double> own;
    for (const std::size_t i : part)
        own.push_back(areas[i]);
    const ScaledExchange scaled = scaledToClosure(partOfExchange(matrix, part), own, Closure::closedRoom);
    for (std::size_t i = 0; i < part.size(); ++i)
        for (std::size_t j = 0; j <= i; ++j)
            matrix.set(part[i], part[j], scaled.exchange(i, j));
    return scaled.largestChange;
}

} // namespace

PreparedExchange preparedExchange(ExchangeMatrix matrix, std::span<const Patch> patches,
                                  std::span<const double> surroundings, bool scales) {
    PreparedExchange made;
    for (const Patch& patch : patches)
        made.areas.push_back(patch.area);
    made.rowSums = rowSums(matrix, made.areas);
    made.isClosed = std::ranges::all_of(surroundings, [](double share) { return share == 0; });
    const auto parts = closedParts(matrix, made.areas, surroundings);
    for (const auto& part : parts)
        made.patchesInClosedRooms += part.size();
    if (scales) {
        made.isScaled = true;
        const bool isOneRoom = made.isClosed && parts.size() == 1;
        if (!isOneRoom)
            for (const auto& part : parts)
                made.scalingChanged = std::max(made.scalingChanged, scalePart(matrix, made.areas, part));
        ScaledExchange scaled =
            scaledToClosure(std::move(matrix), made.areas, isOneRoom ? Closure::closedRoom : Closure::openScene);
        if (!scaled.isClosed) // a patch that sees nothing: rows that sum to too much still come down
            scaled = scaledToClosure(std::move(scaled.exchange), made.areas, Closure::openScene);
        made.scalingChanged = std::max(made.scalingChanged, scaled.largestChange);
        made.largestDeviation = scaled.largestDeviation;
        matrix = std::move(scaled.exchange);
    } else {
        for (const double sum : made.rowSums)
            made.largestDeviation =
                std::max(made.largestDeviation, made.isClosed ? std::abs(sum - 1) : std::max(0.0, sum - 1));
    }
    made.reciprocityResidual = reciprocityResidual(matrix, made.areas);
    made.matrix = std::move(matrix);
    return made;
}

} // namespace shadowlab::radiosity
