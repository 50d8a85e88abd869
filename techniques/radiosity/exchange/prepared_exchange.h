// The exchange matrix as the equations use it, and what is known about it.
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
    std::vector<double> rowSums;          ///< of the form factors as they were found
    std::vector<double> rowDeviations;    ///< how far off these are expected to be, one standard deviation at most
    bool isClosed = false;                ///< no patch sees anything but patches
    std::size_t patchesInClosedRooms = 0; ///< in an open scene some may be (closed_parts.h)
    bool isScaled = false;
    double scalingChanged = 0;   ///< the largest relative change of a form factor
    double largestDeviation = 0; ///< what is left of |row sum - 1|; in an open scene, above 1
    double reciprocityResidual = 0;
    ExchangeCounts counts;
};

/// Which patches lie in a closed room, though the scene is open?
///
/// The outside of a house and its rooms exchange nothing. So patches are parted: two are of one part if light comes from the one to
/// the other, directly or by way of others. A part of which no patch sees the surroundings is a closed room.
///
/// The patches of each part that is closed, in their order. `areas` in m^2; `surroundings`: of each patch, the share of what it sees
/// that is no surface.
std::vector<std::vector<std::size_t>> closedParts(const ExchangeMatrix& exchange, std::span<const double> areas,
                                                  std::span<const double> surroundings);

/// `surroundings`: of each patch, the share of what it sees that is no surface.
PreparedExchange preparedExchange(ExchangeMatrix matrix, std::span<const Patch> patches,
                                  std::span<const double> surroundings, bool scales);

} // namespace shadowlab::radiosity
