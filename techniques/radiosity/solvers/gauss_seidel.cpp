// Gauss and Seidel's sweeps: patch after patch, each is given the radiosity that its own equation wants, with what those before it
// have just become. All residuals are kept up to date meanwhile (a row of S is a column, too), so that a sweep costs one product
// with the matrix, as Jacobi's does, and the bound of the error is there without another one.
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
