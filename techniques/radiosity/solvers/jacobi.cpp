// Jacobi sweeps: B <- E + rho F B, all patches at once from the previous radiosity. Since the residual is E + rho F B - B, that
// is B <- B + r. From B = 0, sweep k adds the light that was reflected k - 1 times: after k sweeps one sees the light of so many
// bounces. (F_ii needs no special treatment: flat patches do not see themselves.)
// SPDX-License-Identifier: MIT
#include "techniques/radiosity/solvers/solver_kinds.h"

namespace shadowlab::radiosity {

namespace {

class Jacobi final : public IterateSolver {
public:
    explicit Jacobi(Problem problem) : IterateSolver(std::move(problem)) {}

private:
    void advance() override {
        const std::vector<dvec3> change = iterate_.residual();
        iterate_.add(change, iterate_.reflected(change));
        if (glm::any(iterate_.needsFreshResidual())) iterate_.recomputeResidual();
    }
};

} // namespace

std::unique_ptr<Solver> makeJacobi(Problem problem) { return std::make_unique<Jacobi>(std::move(problem)); }

} // namespace shadowlab::radiosity
