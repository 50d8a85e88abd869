// The radiosity equations: B_i = E_i + rho_i sum_j F_ij B_j for every patch i, in three colours (C. Goral, K. Torrance, D.
// Greenberg, B. Battaile, "Modeling the Interaction of Light Between Diffuse Surfaces", SIGGRAPH 1984).
//
// B_i is the radiosity: the flux that leaves patch i, per area. E_i is what the patch emits by itself, rho_i the share that it
// reflects of the light that reaches it. Each colour is a system of its own; all three have the same form factors.
// SPDX-License-Identifier: MIT
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "techniques/foundation/math/types.h"
#include "techniques/radiosity/exchange/exchange_matrix.h"

namespace shadowlab::radiosity {

/// One entry per patch in each vector. The matrix is not copied: it must outlive the problem and all its solvers.
// [anchor: radiosity-problem]
struct Problem {
    const ExchangeMatrix& exchange; ///< S_ij = A_i F_ij, m^2
    std::vector<double> areas;      ///< A_i, m^2, above 0
    std::vector<dvec3> emission;    ///< E_i, W/m^2, at least 0
    std::vector<dvec3> reflectance; ///< rho_i, 0 to 1
};

/// The largest share of the light that is left after one more reflection, for each colour. Rounding is included: the exact values
/// are not above these.
struct ReflectionBounds {
    /// q = max_i rho_i sum_j F_ij: no patch sends on more than q times the largest radiosity around it.
    dvec3 ofLargest{0};
    /// q' = max_j sum_i F_ji rho_i: of the power that leaves any patch, at most q' leaves the patches that it reaches.
    dvec3 ofPower{0};
};

ReflectionBounds reflectionBounds(const Problem& problem);

/// Why the problem cannot be solved, in one sentence with the remedy; nothing where it can. Checked are the lengths of vectors,
/// the ranges of numbers, and that light dies out: q must be below 1 - 1e-9 in every colour that something emits. Otherwise no
/// error bound exists, and a closed room that reflects everything has no solution: the emitted power would add up for ever. In a
/// colour that nothing emits the solution is 0, whatever is reflected.
std::optional<std::string> refusal(const Problem& problem);

/// reflectionBounds(), checked: throws Error (badInput) with the sentence of refusal() where there is no solution.
ReflectionBounds boundsOfSolvable(const Problem& problem);

} // namespace shadowlab::radiosity
