// SPDX-License-Identifier: MIT
#include "techniques/radiosity/prepared_exchange.h"

#include <algorithm>
#include <cmath>

namespace shadowlab::radiosity {

PreparedExchange preparedExchange(ExchangeMatrix matrix, std::span<const Patch> patches,
                                  std::span<const double> surroundings, bool scales) {
    PreparedExchange made;
    for (const Patch& patch : patches)
        made.areas.push_back(patch.area);
    made.rowSums = rowSums(matrix, made.areas);
    made.isClosed = std::ranges::all_of(surroundings, [](double share) { return share == 0; });
    if (scales) {
        ScaledExchange scaled =
            scaledToClosure(std::move(matrix), made.areas, made.isClosed ? Closure::closedRoom : Closure::openScene);
        if (!scaled.isClosed) // a patch that sees nothing: rows that sum to too much still come down
            scaled = scaledToClosure(std::move(scaled.exchange), made.areas, Closure::openScene);
        made.isScaled = true;
        made.scalingChanged = scaled.largestChange;
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
