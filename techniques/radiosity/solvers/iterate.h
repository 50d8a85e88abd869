// A radiosity that is not the solution yet, and what is known for certain of its error. All solvers work on one of these.
//
// With B* the solution of B* = E + rho F B*, and r = E + rho F B - B the residual of another B, the error e = B* - B obeys
//     e = r + rho F e.                                                                                           (1)
// Largest error. Row i of rho F sums to at most q, so |e|max <= |r|max + q |e|max, and
//     |e|max <= |r|max / (1 - q),        q = max_i rho_i sum_j F_ij.                                             (2)
// Error in power. Multiply (1) by A_i and sum: sum A|e| <= sum A|r| + sum_i rho_i sum_j S_ij |e_j|. Sum over i first; since
// S_ij = S_ji = A_j F_ji, each |e_j| A_j is counted sum_i F_ji rho_i times, the mean reflectance of what patch j sees. So
//     sum A|e| <= sum A|r| / (1 - q'),   q' = max_j sum_i F_ji rho_i.                                            (3)
// Where the emitter is white, or all row sums are below 1, q' and q differ; either may be the smaller.
//
// Rounding. What is stored is not r but r^; `drift` bounds |r^ - r| in the largest norm, and (2) and (3) are applied to
// |r^| + drift. It is found step by step, u being half the distance from 1 to the next double. B + x is stored as
// B + x + b with |b| <= u |B + x|; the true residual then changes by rho F (x + b) - (x + b), where rho F x was computed with
// an error of at most g q |x|max (g: gatherRounding). Each of the two operations on r^ errs by u of its result. So
//     drift += g q |x|max + (1 + q) u |B|max + u |r^|max + u |rho F x - x|max,
// second-order terms being covered by a margin of one in a hundred. Drift only grows; when it is no longer small beside the
// residual, r is computed anew from B, whose drift is g q |B|max + u |E + rho F B|max + u |r^|max. Thus the bound still holds
// when a solver has come as near as doubles can. (Numbers below 1e-290, where doubles lose digits, are left out of this.)
// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <span>
#include <vector>

#include "techniques/foundation/math/types.h"
#include "techniques/radiosity/equations/problem.h"

namespace shadowlab::radiosity {

/// Bounds of the linear error: how far B is from the exact solution of the system. That patches are no points, and form factors
/// not exact, is another error and not in here.
struct ErrorBound {
    dvec3 largest{0}; ///< of max_i |B*_i - B_i|, W/m^2, for each colour
    dvec3 power{0};   ///< of sum_i A_i |B*_i - B_i|, W
};

class Iterate {
public:
    /// Begins with B = 0, whose residual is E. Error (badInput) for what `refusal` says of the problem.
    explicit Iterate(Problem problem);

    [[nodiscard]] const Problem& problem() const { return problem_; }
    [[nodiscard]] std::size_t size() const { return problem_.areas.size(); }
    /// B_i, W/m^2.
    [[nodiscard]] const std::vector<dvec3>& radiosity() const { return radiosity_; }
    /// r = E + rho F B - B, W/m^2, as it is kept.
    [[nodiscard]] const std::vector<dvec3>& residual() const { return residual_; }

    /// rho F x.
    [[nodiscard]] std::vector<dvec3> reflected(std::span<const dvec3> x) const;
    /// B becomes B + x. `reflectedChange` is rho F x, or both are multiples of such a pair, as CG has them.
    void add(std::span<const dvec3> x, std::span<const dvec3> reflectedChange);
    /// B_i alone becomes B_i + x: one row of the matrix, which is also its column, brings all residuals up to date.
    void addAt(std::size_t i, const dvec3& x);
    /// By how much B_i has to change for its own equation to hold: r_i / (1 - rho_i F_ii).
    [[nodiscard]] dvec3 correction(std::size_t i) const;

    /// For each colour: is drift more than a fourth of the residual, though computing anew would bring it down? Never more
    /// often than once in the work of one product with the whole matrix.
    [[nodiscard]] glm::bvec3 needsFreshResidual() const;
    void recomputeResidual();

    /// By (2) and (3), for B.
    [[nodiscard]] ErrorBound errorBound() const;
    /// The same for B + r, the radiosity in which light that was received and not yet shot counts: its error is
    /// B* - B - r = rho F e, so (2) and (3) hold with q / (1 - q) and q' / (1 - q') in place of 1 / (1 - q) and 1 / (1 - q').
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
