// The whole system at once, by Cholesky factorisation of the symmetrised matrix (Eigen).
//
// With w_i = sqrt(rho_i / A_i), the system for the correction x, x - rho F x = r, becomes (I - w S w) y = r / w with x = w y. It
// is symmetric and positive definite where light dies out (its eigenvalues are at least 1 - q), and takes half the work of
// Gaussian elimination. Where rho_i = 0 the row is that of the identity, and the correction is 0 once B_i = E_i. Colours with the
// same reflectances share a factor. A second step refines the first (iterative refinement): the same factor is solved with the
// new residual.
// SPDX-License-Identifier: MIT
#include <array>
#include <cmath>
#include <optional>
#include <string>

#include <Eigen/Cholesky>
#include <Eigen/Core>

#include "techniques/radiosity/solvers/solver_kinds.h"

namespace shadowlab::radiosity {

namespace {

class Direct final : public IterateSolver {
public:
    explicit Direct(Problem problem) : IterateSolver(std::move(problem)) {
        const std::vector<dvec3> emission = iterate_.problem().emission;
        iterate_.add(emission, iterate_.reflected(emission));
    }

private:
    using Factor = Eigen::LLT<Eigen::MatrixXd>;

    void advance() override {
        std::vector<dvec3> missing(iterate_.size(), dvec3(0));
        for (int c = 0; c < 3; ++c)
            if (hasLight(c)) solveColour(c, missing);
        iterate_.add(missing, iterate_.reflected(missing));
        if (glm::any(iterate_.needsFreshResidual())) iterate_.recomputeResidual();
    }

    /// A colour without light needs no factor, and may have none: its reflectances may all be 1.
    [[nodiscard]] bool hasLight(int colour) const {
        for (const dvec3& value : iterate_.problem().emission)
            if (value[colour] > 0) return true;
        return false;
    }

    [[nodiscard]] double weight(std::size_t i, int colour) const {
        return std::sqrt(iterate_.problem().reflectance[i][colour] / iterate_.problem().areas[i]);
    }

    void solveColour(int colour, std::vector<dvec3>& missing) {
        const auto size = static_cast<Eigen::Index>(iterate_.size());
        Eigen::VectorXd weights(size), right(size);
        for (Eigen::Index i = 0; i < size; ++i) {
            weights[i] = weight(static_cast<std::size_t>(i), colour);
            const double residual = iterate_.residual()[static_cast<std::size_t>(i)][colour];
            right[i] = weights[i] > 0 ? residual / weights[i] : 0.0;
        }
        const Eigen::VectorXd y = factorFor(colour, weights).solve(right);
        for (Eigen::Index i = 0; i < size; ++i)
            missing[static_cast<std::size_t>(i)][colour] = weights[i] * y[i];
    }

    const Factor& factorFor(int colour, const Eigen::VectorXd& weights) {
        for (int other = 0; other < 3; ++other)
            if (factors_[other] && hasSameReflectance(colour, other)) return *factors_[other];
        const Eigen::Index size = weights.size();
        Eigen::MatrixXd matrix(size, size); // only the lower half is read; its columns are rows of S
        for (Eigen::Index column = 0; column < size; ++column) {
            const std::span<const double> row = iterate_.problem().exchange.row(static_cast<std::size_t>(column));
            for (Eigen::Index i = column; i < size; ++i)
                matrix(i, column) = -weights[column] * row[static_cast<std::size_t>(i)] * weights[i];
            matrix(column, column) += 1;
        }
        return factors_[colour].emplace(std::move(matrix));
    }

    [[nodiscard]] bool hasSameReflectance(int colour, int other) const {
        for (const dvec3& rho : iterate_.problem().reflectance)
            if (rho[colour] != rho[other]) return false;
        return true;
    }

    std::array<std::optional<Factor>, 3> factors_;
};

} // namespace

std::unique_ptr<Solver> makeDirect(Problem problem) { return std::make_unique<Direct>(std::move(problem)); }

} // namespace shadowlab::radiosity
