// SPDX-License-Identifier: MIT
#include "techniques/radiosity/exchange/prepared_exchange.h"

#include <algorithm>
#include <cmath>

namespace shadowlab::radiosity {

namespace {

// A smaller share of the smaller patch's light is not a connection: a few sample lines between two patches slip past the very
// edge of a wall. The 256 rays that look for the surroundings would miss gaps of that size, too.
constexpr double kLink = 1e-3;

ExchangeMatrix partOfExchange(const ExchangeMatrix& all, std::span<const std::size_t> part) {
    ExchangeMatrix some(part.size());
    for (std::size_t i = 0; i < part.size(); ++i)
        for (std::size_t j = 0; j <= i; ++j)
            some.set(i, j, all(part[i], part[j]));
    return some;
}

/// Scales a closed part of the matrix until its rows sum to 1; returns by how much that changed it. Where no scaling exists it
/// stays.
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

std::vector<std::vector<std::size_t>> closedParts(const ExchangeMatrix& exchange, std::span<const double> areas,
                                                  std::span<const double> surroundings) {
    std::vector<std::vector<std::size_t>> closed;
    std::vector<bool> isKnown(exchange.size(), false);
    for (std::size_t first = 0; first < exchange.size(); ++first) {
        if (isKnown[first]) continue;
        std::vector<std::size_t> part{first};
        isKnown[first] = true;
        for (std::size_t next = 0; next < part.size(); ++next) { // grows during the loop
            const std::size_t from = part[next];
            const std::span<const double> row = exchange.row(from);
            for (std::size_t to = 0; to < row.size(); ++to) {
                if (isKnown[to] || !(row[to] > kLink * std::min(areas[from], areas[to]))) continue;
                isKnown[to] = true;
                part.push_back(to);
            }
        }
        if (part.size() == 1) continue; // it sees no patch: not a room
        if (std::ranges::any_of(part, [&](std::size_t i) { return surroundings[i] != 0; })) continue;
        std::ranges::sort(part);
        closed.push_back(std::move(part));
    }
    return closed;
}

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
        if (!scaled.isClosed) // a patch sees nothing, so only rows that sum to more than 1 are corrected
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
