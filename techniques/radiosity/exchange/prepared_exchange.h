// The exchange matrix as the equations use it, scaled if that is wanted, and its figures of quality.
// SPDX-License-Identifier: MIT
#pragma once
#include <span>
#include <string>
#include <vector>

#include "techniques/radiosity/exchange/exchange_builder.h"

namespace shadowlab::radiosity {

struct PreparedExchange {
    ExchangeMatrix matrix{0};
    std::vector<double> areas;            ///< m^2
    std::vector<double> rowSums;          ///< of the form factors before scaling
    std::vector<double> rowDeviations;    ///< an upper bound of their standard deviations
    bool isClosed = false;                ///< patches see nothing but patches
    std::size_t patchesInClosedRooms = 0; ///< in an open scene some may be (closedParts)
    bool isScaled = false;
    double scalingChanged = 0;   ///< the largest relative change of a form factor
    double largestDeviation = 0; ///< |row sum - 1| after scaling; in an open scene, row sum - 1
    double reciprocityResidual = 0;
    ExchangeCounts counts;
};

/// The patches of each closed room of an open scene: the outside of a house and its rooms exchange nothing. Patches are split
/// into parts: two are in the same part if light gets from one to the other, directly or by way of other patches. A part of which
/// no patch sees the surroundings is a closed room. Patches in order; `areas` in m^2; `surroundings`: for each patch, the share
/// of its view that is no surface.
std::vector<std::vector<std::size_t>> closedParts(const ExchangeMatrix& exchange, std::span<const double> areas,
                                                  std::span<const double> surroundings);

/// `surroundings`: for each patch, the share of its view that is no surface.
PreparedExchange preparedExchange(ExchangeMatrix matrix, std::span<const Patch> patches,
                                  std::span<const double> surroundings, bool scales);

} // namespace shadowlab::radiosity
