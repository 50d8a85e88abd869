// Southwell's relaxation (R. Southwell, "Relaxation Methods in Engineering Science", 1940), gathering: each step takes the patch
// with the largest residual of any colour and solves its equation. Of patches with equal residuals it takes the first.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include "techniques/radiosity/solvers/solver_kinds.h"

namespace shadowlab::radiosity {

namespace {

double largestMagnitude(const dvec3& residual) {
    return std::max({std::abs(residual.x), std::abs(residual.y), std::abs(residual.z)});
}

class Southwell final : public IterateSolver {
public:
    explicit Southwell(Problem problem) : IterateSolver(std::move(problem)) {}

private:
    void advance() override {
        const auto& residual = iterate_.residual();
        const auto furthest = std::ranges::max_element(residual, {}, largestMagnitude);
        const auto i = static_cast<std::size_t>(furthest - residual.begin());
        iterate_.addAt(i, iterate_.correction(i));
        if (glm::any(iterate_.needsFreshResidual())) iterate_.recomputeResidual();
    }
};

} // namespace

std::unique_ptr<Solver> makeSouthwell(Problem problem) { return std::make_unique<Southwell>(std::move(problem)); }

} // namespace shadowlab::radiosity
