// What is to be solved: B_i = E_i + rho_i sum_j F_ij B_j for every patch i (C. Goral, K. Torrance, D. Greenberg, B. Battaile,
// "Modeling the Interaction of Light Between Diffuse Surfaces", SIGGRAPH 1984), in three colours at once.
//
// B is the radiosity: what leaves a patch, per area. E is what it emits by itself, rho what it reflects of the light that
// reaches it. Each colour is a system of its own; they share the form factors.
// SPDX-License-Identifier: MIT
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "techniques/foundation/math/types.h"
#include "techniques/radiosity/exchange/exchange_matrix.h"

namespace shadowlab::radiosity {

/// One entry of each vector for every patch. The matrix is not copied: it has to outlive the problem and all its solvers.
// [anchor: radiosity-problem]
struct Problem {
    const ExchangeMatrix& exchange; ///< S_ij = A_i F_ij, m^2
    std::vector<double> areas;      ///< A_i, m^2, above 0
    std::vector<dvec3> emission;    ///< E_i, W/m^2, at least 0
    std::vector<dvec3> reflectance; ///< rho_i, 0 to 1
};

/// How much of the light is left at most after it was reflected once more, for each colour. Rounding is included: the true
/// numbers are not above these.
struct ReflectionBounds {
    /// q = max_i rho_i sum_j F_ij: no patch sends on more than q times the largest radiosity around it.
    dvec3 ofLargest{0};
    /// q' = max_j sum_i F_ji rho_i: of the power that leaves any patch, at most q' leaves the patches that it reaches.
    dvec3 ofPower{0};
};

ReflectionBounds reflectionBounds(const Problem& problem);

/// Why the problem cannot be solved, in one sentence with the mend; nothing where it can. Looked for are vectors of different
/// lengths, numbers out of range, and light that never dies out: q of 1 - 1e-9 or more in a colour that something emits.
/// Then no bound of the error exists, and in a closed room that reflects everything no solution either: every watt emitted
/// would stay for ever. In a colour that nothing emits the solution is 0, whatever is reflected.
std::optional<std::string> refusal(const Problem& problem);

/// The bounds of a problem that can be solved; Error (badInput) with the sentence above for others.
ReflectionBounds boundsOfSolvable(const Problem& problem);

} // namespace shadowlab::radiosity
