// The light that reaches every patch from all others: one product of the form factors with a vector.
// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <span>
#include <vector>

#include "techniques/foundation/math/types.h"
#include "techniques/radiosity/exchange/exchange_matrix.h"

namespace shadowlab::radiosity {

/// H_i = sum_j F_ij B_j, the irradiance in W/m^2 for radiosities B in W/m^2, for three colours at once: the matrix, by far
/// the most that has to be read, is read once for all of them. On all threads; the result does not depend on how many.
std::vector<dvec3> gathered(const ExchangeMatrix& exchange, std::span<const double> areas,
                            std::span<const dvec3> radiosity);

/// Half the distance from 1 to the next double: no operation errs by a larger share of its result.
constexpr double kRoundingUnit = 0x1p-53;

/// How far rounding takes what `gathered` returns from the true sum, as a share of sum_j F_ij |B_j|. A product of k factors
/// (1 + d) with |d| <= u lies within k u / (1 - k u) of 1 (N. Higham, "Accuracy and Stability of Numerical Algorithms",
/// 2002, chapter 3), and every summand goes through at most as many roundings as are counted here.
double gatherRounding(std::size_t patches);

} // namespace shadowlab::radiosity
