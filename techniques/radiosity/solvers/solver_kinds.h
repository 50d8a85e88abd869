// What makeSolver() chooses from, and what nearly all solvers have in common.
// SPDX-License-Identifier: MIT
#pragma once
#include <memory>
#include <utility>
#include <vector>

#include "techniques/radiosity/solvers/solvers.h"

namespace shadowlab::radiosity {

std::unique_ptr<Solver> makeDirect(Problem problem);
std::unique_ptr<Solver> makeJacobi(Problem problem);
std::unique_ptr<Solver> makeGaussSeidel(Problem problem);
std::unique_ptr<Solver> makeSouthwell(Problem problem);
std::unique_ptr<Solver> makeShooting(Problem problem);
std::unique_ptr<Solver> makeConjugateGradients(Problem problem);

/// A solver whose iterate is the radiosity that it reports: all but shooting.
class IterateSolver : public Solver {
public:
    [[nodiscard]] const std::vector<dvec3>& radiosity() const final { return iterate_.radiosity(); }
    [[nodiscard]] std::vector<dvec3> residual() const final { return iterate_.residual(); }
    [[nodiscard]] ErrorBound errorBound() const final { return iterate_.errorBound(); }

protected:
    explicit IterateSolver(Problem problem) : iterate_(std::move(problem)) {}
    Iterate iterate_;
};

} // namespace shadowlab::radiosity
