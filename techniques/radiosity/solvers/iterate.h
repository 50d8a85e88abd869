// An approximate radiosity, its residual, and a proven bound of its error. All solvers work on one.
//
// Let B* be the solution of B* = E + rho F B*, and r = E + rho F B - B the residual of another B. The error e = B* - B obeys
//     e = r + rho F e.                                                                                           (1)
// Largest error. Row i of rho F sums to at most q, so |e|max <= |r|max + q |e|max, and
//     |e|max <= |r|max / (1 - q),        q = max_i rho_i sum_j F_ij.                                             (2)
// Error in power. Multiply (1) by A_i and sum: sum A|e| <= sum A|r| + sum_i rho_i sum_j S_ij |e_j|. Sum over i first; since S_ij
// = S_ji = A_j F_ji, each |e_j| A_j is counted sum_i F_ji rho_i times, the mean reflectance of what patch j sees. So
//     sum A|e| <= sum A|r| / (1 - q'),   q' = max_j sum_i F_ji rho_i.                                            (3)
// q and q' differ where reflectances do; either may be the smaller.
//
// Rounding. What is stored is not r but r^. `drift` bounds |r^ - r| in the largest norm, and (2) and (3) are applied to |r^| +
// drift. Let u be the unit roundoff. A step by x stores B + x + b with |b| <= u |B + x|; the true residual then changes by rho F
// (x + b) - (x + b), where rho F x was computed with an error of at most g q |x|max (g: gatherRounding). Each of the two
// operations on r^ has a relative error of u. So
//     drift += g q |x|max + (1 + q) u |B|max + u |r^|max + u |rho F x - x|max,
// where a margin of one in a hundred covers second-order terms. Drift only grows. When it is no longer small compared with the
// residual, r is recomputed from B, with a drift of g q |B|max + u |E + rho F B|max + u |r^|max. So the bound still holds when a
// solver has converged to the precision of double. (Numbers below 1e-290, where doubles lose digits, are not covered.)
// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <span>
#include <vector>

#include "techniques/foundation/math/types.h"
#include "techniques/radiosity/equations/problem.h"

namespace shadowlab::radiosity {

/// Bounds of the error of solving: how far B is from the exact solution of the system. The error of cutting surfaces into
/// patches, and that of the form factors, come on top.
struct ErrorBound {
    dvec3 largest{0}; ///< of max_i |B*_i - B_i|, W/m^2, for each colour
    dvec3 power{0};   ///< of sum_i A_i |B*_i - B_i|, W
};

class Iterate {
public:
    /// Starts with B = 0, whose residual is E. Throws Error (badInput) with what `refusal` says of the problem.
    explicit Iterate(Problem problem);

    [[nodiscard]] const Problem& problem() const { return problem_; }
    [[nodiscard]] std::size_t size() const { return problem_.areas.size(); }
    /// B_i, W/m^2.
    [[nodiscard]] const std::vector<dvec3>& radiosity() const { return radiosity_; }
    /// r = E + rho F B - B, W/m^2, as it is stored.
    [[nodiscard]] const std::vector<dvec3>& residual() const { return residual_; }

    /// rho F x.
    [[nodiscard]] std::vector<dvec3> reflected(std::span<const dvec3> x) const;
    /// B becomes B + x. `reflectedChange` is rho F x, or both are the same multiple of such a pair, as in conjugate gradients.
    void add(std::span<const dvec3> x, std::span<const dvec3> reflectedChange);
    /// B_i alone becomes B_i + x: one row of the matrix, which is also its column, updates all residuals.
    void addAt(std::size_t i, const dvec3& x);
    /// The change of B_i that solves its own equation: r_i / (1 - rho_i F_ii).
    [[nodiscard]] dvec3 correction(std::size_t i) const;

    /// For each colour: is drift more than a fourth of the residual, and would recomputing reduce it? At most once per work of
    /// one product with the whole matrix.
    [[nodiscard]] glm::bvec3 needsFreshResidual() const;
    void recomputeResidual();

    /// By (2) and (3), for B.
    [[nodiscard]] ErrorBound errorBound() const;
    /// The same for B + r, where light counts that was received and not yet shot: its error is B* - B - r = rho F e, so (2) and
    /// (3) hold with q / (1 - q) and q' / (1 - q') in place of 1 / (1 - q) and 1 / (1 - q').
    [[nodiscard]] ErrorBound errorBoundWithResidual() const;

private:
    [[nodiscard]] dvec3 freshDrift() const;
    [[nodiscard]] ErrorBound errorBound(const dvec3& factorLargest, const dvec3& factorPower, double inSum) const;

    Problem problem_;
    ReflectionBounds reflects_;
    std::vector<dvec3> radiosity_, residual_;
    std::vector<dvec3> reflectancePerArea_; ///< rho_i / A_i, 1/m^2
    double totalArea_ = 0;                  ///< m^2
    dvec3 largestRadiosity_{0}, largestResidual_{0}, drift_{0};
    double workSinceFresh_ = 0; ///< in products with the whole matrix
};

} // namespace shadowlab::radiosity
