// The irradiance of every patch by all others: one product of the matrix of form factors with a vector.
// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <span>
#include <vector>

#include "techniques/foundation/math/types.h"
#include "techniques/radiosity/exchange/exchange_matrix.h"

namespace shadowlab::radiosity {

/// H_i = sum_j F_ij B_j, the irradiance in W/m^2 for radiosities B in W/m^2, for three colours at once, because reading the
/// matrix takes most of the time. On all threads; the result does not depend on their number.
std::vector<dvec3> gathered(const ExchangeMatrix& exchange, std::span<const double> areas,
                            std::span<const dvec3> radiosity);

/// The unit roundoff of double: no operation has a larger relative error.
constexpr double kRoundingUnit = 0x1p-53;

/// A bound of the rounding error of `gathered`, relative to sum_j F_ij |B_j|. A product of k factors (1 + d) with |d| <= u lies
/// within k u / (1 - k u) of 1 (N. Higham, "Accuracy and Stability of Numerical Algorithms", 2002, chapter 3), and every summand
/// goes through at most as many roundings as are counted here.
double gatherRounding(std::size_t patches);

} // namespace shadowlab::radiosity
