// The light that was reflected exactly k times, and where the power of a solution goes.
// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <span>
#include <vector>

#include "techniques/foundation/math/types.h"
#include "techniques/radiosity/equations/problem.h"

namespace shadowlab::radiosity {

/// B_k, W/m^2: the part of the radiosity that was reflected exactly k times. B_0 = E, B_k = rho F B_{k-1}; the sum over all k is
/// B.
std::vector<dvec3> bounce(const Problem& problem, std::size_t k);

/// B_k = rho F B_{k-1}, from B_{k-1}.
std::vector<dvec3> nextBounce(const Problem& problem, std::span<const dvec3> bounceBefore);

/// H_i = sum_j F_ij B_j, the irradiance that reaches each patch, W/m^2.
std::vector<dvec3> irradiance(const Problem& problem, const std::vector<dvec3>& radiosity);

/// Where the power goes, W. For the solution, emitted = absorbed + escaped: multiply B = E + rho H by A_i, sum over all patches,
/// and use sum A_i H_i = sum_j B_j sum_i S_ij. In a closed room nothing escapes, so sum A E = sum A (1 - rho) H. (A patch absorbs
/// a share of the irradiance H that reaches it; the radiosity B is what leaves it.)
struct EnergyBalance {
    dvec3 emitted{0};  ///< sum A_i E_i
    dvec3 absorbed{0}; ///< sum A_i (1 - rho_i) H_i
    dvec3 escaped{0};  ///< sum A_i (1 - sum_j F_ij) B_i
    /// (emitted - absorbed - escaped) / emitted; 0 for a colour that nothing emits.
    [[nodiscard]] dvec3 residual() const;
    /// (emitted - absorbed) / emitted: 0 in a closed room.
    [[nodiscard]] dvec3 closedResidual() const;
};

EnergyBalance energyBalance(const Problem& problem, const std::vector<dvec3>& radiosity);

} // namespace shadowlab::radiosity
