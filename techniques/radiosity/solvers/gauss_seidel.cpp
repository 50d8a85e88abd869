// Gauss-Seidel sweeps: patch after patch gets the radiosity that solves its own equation, given the newest values of all others.
// All residuals are kept up to date (a row of S is also a column), so that a sweep costs one product with the matrix, as Jacobi's
// does, and the error bound needs no further product.
// SPDX-License-Identifier: MIT
#include "techniques/radiosity/solvers/solver_kinds.h"

namespace shadowlab::radiosity {

namespace {

class GaussSeidel final : public IterateSolver {
public:
    explicit GaussSeidel(Problem problem) : IterateSolver(std::move(problem)) {}

private:
    void advance() override {
        for (std::size_t i = 0; i < iterate_.size(); ++i)
            iterate_.addAt(i, iterate_.correction(i));
        if (glm::any(iterate_.needsFreshResidual())) iterate_.recomputeResidual();
    }
};

} // namespace

std::unique_ptr<Solver> makeGaussSeidel(Problem problem) { return std::make_unique<GaussSeidel>(std::move(problem)); }

} // namespace shadowlab::radiosity
