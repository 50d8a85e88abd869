// Progressive refinement (M. Cohen, S. Chen, J. Wallace, D. Greenberg, "A Progressive Refinement Approach to Fast Radiosity Image
// Generation", SIGGRAPH 1988): each step, the patch with the most unshot power shoots it to all others; they reflect their
// shares, which are then unshot in turn.
//
// What was shot is an iterate x like any other, and the unshot radiosity is its residual: shooting is relaxation. It differs from
// Southwell's steps in the choice of the patch (most power, not the largest residual) and in what is shown: B = x + unshot, in
// which light counts as soon as it is received. So, but for rounding, radiosities only grow and never exceed the solution, and of
// two pictures the later is better.
// SPDX-License-Identifier: MIT
#include <algorithm>

#include "techniques/radiosity/exchange/exchange_matrix.h"
#include "techniques/radiosity/solvers/solver_kinds.h"

namespace shadowlab::radiosity {

namespace {

class Shooting final : public Solver {
public:
    explicit Shooting(Problem problem) : shot_(std::move(problem)), radiosity_(shot_.residual()) {
        const Problem& room = shot_.problem();
        const std::vector<double> sums = rowSums(room.exchange, room.areas);
        seen_ = sums;
        for (std::size_t i = 0; i < sums.size(); ++i) {
            totalArea_ += room.areas[i];
            meanReflected_ += room.areas[i] * sums[i] * room.reflectance[i];
        }
        meanReflected_ /= totalArea_;
    }

    [[nodiscard]] const std::vector<dvec3>& radiosity() const override { return radiosity_; }
    /// With B = x + unshot, E + rho F B - B = (E + rho F x - x) - unshot + rho F unshot = rho F unshot.
    [[nodiscard]] std::vector<dvec3> residual() const override { return shot_.reflected(shot_.residual()); }
    [[nodiscard]] ErrorBound errorBound() const override { return shot_.errorBoundWithResidual(); }

    [[nodiscard]] std::optional<dvec3> unshotPower() const override {
        dvec3 power(0);
        for (std::size_t i = 0; i < shot_.size(); ++i)
            power += powerOf(i);
        return power;
    }

    /// The ambient term: an estimate that spreads the unshot power evenly over all surfaces and reflects it R = 1 + k + k^2 ... =
    /// 1 / (1 - k) times, k being the mean reflectance by area. The paper has closed rooms; here every patch is weighted by its
    /// row sum (1 in a closed room), because light that escapes is not reflected.
    [[nodiscard]] std::vector<dvec3> shown() const override {
        const dvec3 meanUnshot = *unshotPower() / totalArea_;
        dvec3 ambient(0);
        for (int c = 0; c < 3; ++c)
            if (meanUnshot[c] > 0)
                ambient[c] = meanUnshot[c] / (1 - meanReflected_[c]); // k <= q < 1 where there is light
        std::vector<dvec3> estimate = radiosity_;
        for (std::size_t i = 0; i < estimate.size(); ++i)
            estimate[i] += shot_.problem().reflectance[i] * seen_[i] * ambient;
        return estimate;
    }

private:
    [[nodiscard]] dvec3 powerOf(std::size_t i) const { return shot_.problem().areas[i] * shot_.residual()[i]; }

    void advance() override {
        std::size_t brightest = 0; // the first of equals; the sum of the colours decides
        double most = 0;
        for (std::size_t i = 0; i < shot_.size(); ++i) {
            const dvec3 power = powerOf(i);
            if (const double sum = power.x + power.y + power.z; sum > most) {
                most = sum;
                brightest = i;
            }
        }
        shot_.addAt(brightest, dvec3(shot_.residual()[brightest]));
        if (glm::any(shot_.needsFreshResidual())) shot_.recomputeResidual();
        for (std::size_t i = 0; i < shot_.size(); ++i)
            radiosity_[i] = shot_.radiosity()[i] + shot_.residual()[i];
    }

    Iterate shot_;
    std::vector<dvec3> radiosity_;
    std::vector<double> seen_; ///< row sums
    double totalArea_ = 0;     ///< m^2
    dvec3 meanReflected_{0};   ///< k
};

} // namespace

std::unique_ptr<Solver> makeShooting(Problem problem) { return std::make_unique<Shooting>(std::move(problem)); }

} // namespace shadowlab::radiosity
