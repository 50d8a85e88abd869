// Which patches lie in a closed room, though the scene is open?
//
// The outside of a house and its rooms exchange nothing. So patches are parted: two are of one part if light comes from the one to
// the other, directly or by way of others. A part of which no patch sees the surroundings is a closed room.
// SPDX-License-Identifier: MIT
#pragma once
#include <span>
#include <vector>

#include "techniques/radiosity/form_factors/exchange_matrix.h"

namespace shadowlab::radiosity {

/// The patches of each part that is closed, in their order. `areas` in m^2; `surroundings`: of each patch, the share of what it sees
/// that is no surface.
std::vector<std::vector<std::size_t>> closedParts(const ExchangeMatrix& exchange, std::span<const double> areas,
                                                  std::span<const double> surroundings);

} // namespace shadowlab::radiosity
