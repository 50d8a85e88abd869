// Conjugate gradients (M. Hestenes, E. Stiefel 1952) on the symmetrised system.
//
// I - rho F is not symmetric. Multiply row i by D_i = A_i / rho_i; with S_ij = A_i F_ij it becomes (D - S) B = D E, which is
// symmetric. Patches with rho = 0 have B = E and drop out: the iteration starts with B = E everywhere, so their residual is 0 and
// stays 0, and their light is on the right-hand side. D - S is positive definite where light dies out: it is D^1/2 (I - D^-1/2 S
// D^-1/2) D^1/2, and D^-1/2 S D^-1/2 has the eigenvalues of rho F, all between -q and q, q < 1.
//
// Jacobi's preconditioner divides by the diagonal, D_i (1 - rho_i F_ii). The residual of the symmetric system is D r, with r that
// of the original one, so D drops out of all vectors and remains only in the inner products:
//     z = r / (1 - rho_i F_ii),  p <- z + (new r.z / old r.z) p,  step = r.z / p.(p - rho F p),  a.b = sum A_i / rho_i a_i b_i.
// One reflection already mixes the light of a room well: one eigenvalue of rho F is near q, the others are clustered around 0.
// Each step removes one cluster from the error, so few steps are needed, however near to 1 rho is. The three colours are three
// such systems; a step of all three reads the matrix once.
// SPDX-License-Identifier: MIT
#include <cmath>

#include "techniques/radiosity/solvers/solver_kinds.h"

namespace shadowlab::radiosity {

namespace {

class ConjugateGradients final : public IterateSolver {
public:
    explicit ConjugateGradients(Problem problem)
        : IterateSolver(std::move(problem)), direction_(iterate_.size(), dvec3(0)) {
        const std::vector<dvec3> emission = iterate_.problem().emission;
        iterate_.add(emission, iterate_.reflected(emission));
    }

private:
    void advance() override {
        std::vector<dvec3> preconditioned(iterate_.size());
        for (std::size_t i = 0; i < iterate_.size(); ++i)
            preconditioned[i] = iterate_.correction(i);
        const dvec3 product = inner(iterate_.residual(), preconditioned);
        dvec3 turn(0);
        for (int c = 0; c < 3; ++c)
            if (lastProduct_[c] > 0) turn[c] = product[c] / lastProduct_[c];
        lastProduct_ = product;
        for (std::size_t i = 0; i < iterate_.size(); ++i)
            direction_[i] = preconditioned[i] + turn * direction_[i];
        restartWhereRoundingDominates(preconditioned, product);

        std::vector<dvec3> reflected = iterate_.reflected(direction_), change(iterate_.size());
        for (std::size_t i = 0; i < iterate_.size(); ++i)
            change[i] = direction_[i] - reflected[i];
        const dvec3 curvature = inner(direction_, change);
        dvec3 length(0);
        for (int c = 0; c < 3; ++c)
            if (curvature[c] > 0) length[c] = product[c] / curvature[c];
        for (std::size_t i = 0; i < iterate_.size(); ++i) {
            change[i] = length * direction_[i];
            reflected[i] *= length;
        }
        iterate_.add(change, reflected);

        const glm::bvec3 isStale = iterate_.needsFreshResidual();
        if (!glm::any(isStale)) return;
        iterate_.recomputeResidual();
        for (int c = 0; c < 3; ++c)
            if (isStale[c]) lastProduct_[c] = 0; // the directions belong to the old residual: restart
    }

    /// In exact arithmetic r.p = r.z. Once a colour is solved to the precision of double, r is rounding noise, the two differ,
    /// and further steps would lead away from the solution.
    void restartWhereRoundingDominates(const std::vector<dvec3>& preconditioned, const dvec3& product) {
        const dvec3 along = inner(iterate_.residual(), direction_);
        for (int c = 0; c < 3; ++c)
            if (std::abs(along[c] - product[c]) > 0.1 * product[c])
                for (std::size_t i = 0; i < iterate_.size(); ++i)
                    direction_[i][c] = preconditioned[i][c];
    }

    /// sum A_i / rho_i a_i b_i, over patches that reflect. a / rho is computed first: it is of the size of the irradiance, while
    /// rho may be so small that its square underflows.
    [[nodiscard]] dvec3 inner(const std::vector<dvec3>& a, const std::vector<dvec3>& b) const {
        const Problem& room = iterate_.problem();
        dvec3 sum(0);
        for (std::size_t i = 0; i < a.size(); ++i)
            for (int c = 0; c < 3; ++c)
                if (const double rho = room.reflectance[i][c]; rho > 0)
                    sum[c] += a[i][c] / rho * (room.areas[i] * b[i][c]);
        return sum;
    }

    std::vector<dvec3> direction_;
    dvec3 lastProduct_{0}; ///< r.z of the step before; 0 where there is none
};

} // namespace

std::unique_ptr<Solver> makeConjugateGradients(Problem problem) {
    return std::make_unique<ConjugateGradients>(std::move(problem));
}

} // namespace shadowlab::radiosity
