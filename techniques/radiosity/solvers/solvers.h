// Six ways to solve for the radiosity. Each goes step by step, so that the room can be shown while it brightens, and says after
// every step how far off it is at most.
//
//   direct               Cholesky on the symmetrised system: one step, whatever the reflectances are; for up to 3000 patches
//   jacobi               one more bounce of all the light with every sweep
//   gauss-seidel         as Jacobi, but each patch already uses what those before it have become: about half the sweeps
//   southwell            one patch a step: the one whose own equation is furthest from true
//   shooting             progressive refinement: one patch a step shoots all that it has not shot yet
//   conjugate-gradients  on the symmetrised system: few sweeps even where nearly all light is reflected
//
// With q = max rho_i sum_j F_ij, sweeps of the simple ones divide the error by about 1/q: at rho = .999 they need 14,000 (7000)
// for six digits. Conjugate gradients need many only where the eigenvalues of rho F are spread out, which in rooms they are not.
// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <cstddef>
#include <memory>
#include <optional>
#include <string_view>
#include <vector>

#include "techniques/foundation/math/types.h"
#include "techniques/radiosity/equations/problem.h"
#include "techniques/radiosity/solvers/iterate.h"

namespace shadowlab::radiosity {

enum class SolverKind { direct, jacobi, gaussSeidel, southwell, shooting, conjugateGradients };
inline constexpr std::array kSolverKinds = {SolverKind::direct,      SolverKind::jacobi,
                                            SolverKind::gaussSeidel, SolverKind::southwell,
                                            SolverKind::shooting,    SolverKind::conjugateGradients};

/// As in the list above.
std::string_view nameOf(SolverKind kind);

/// More patches than this the direct solver refuses: its factor takes 72 MB for each colour, and some ten seconds.
constexpr std::size_t kMostPatchesDirect = 3000;

/// A solution under way. Steps can stop after any of them and go on later; what is seen in between is always valid. The same
/// steps give the same bits, on any number of threads.
class Solver {
public:
    virtual ~Solver() = default;
    Solver(const Solver&) = delete;
    Solver& operator=(const Solver&) = delete;

    /// One sweep over all patches, or one shot. Nothing to wait for but its own work: at most one or two products with the matrix,
    /// but for the direct solver, whose first step is all of it.
    void step() {
        advance();
        ++steps_;
    }
    [[nodiscard]] std::size_t steps() const { return steps_; }

    /// B_i, W/m^2.
    [[nodiscard]] virtual const std::vector<dvec3>& radiosity() const = 0;
    /// E + rho F B - B, W/m^2. While shooting it takes a product with the matrix; elsewhere it is at hand.
    [[nodiscard]] virtual std::vector<dvec3> residual() const = 0;
    /// How far `radiosity` is from the solution at most (iterate.h has the proof).
    [[nodiscard]] virtual ErrorBound errorBound() const = 0;
    /// The power that was received and not yet shot, W; only while shooting.
    [[nodiscard]] virtual std::optional<dvec3> unshotPower() const { return std::nullopt; }
    /// What to show meanwhile, W/m^2: while shooting, with the ambient term. An estimate for the eye: no step uses it, and the
    /// bound does not speak of it.
    [[nodiscard]] virtual std::vector<dvec3> shown() const { return radiosity(); }

protected:
    Solver() = default;

private:
    virtual void advance() = 0;
    std::size_t steps_ = 0;
};

/// Error (overLimit) for more patches than the direct solver takes: to be asked before form factors are found for nothing.
void requireFewPatches(SolverKind kind, std::size_t patches);

/// Error: badInput for what `refusal` says of the problem, overLimit as above.
std::unique_ptr<Solver> makeSolver(SolverKind kind, Problem problem);

/// Is the error of every colour certainly at most `tolerance` times the largest B of all patches and colours? The rule to stop by:
/// a small residual, or little power unshot, says nothing where nearly all light is reflected.
bool isSolved(const Solver& solver, double tolerance);

/// Steps until `isSolved`, or `mostSteps` times. Returns whether it is.
bool solve(Solver& solver, double tolerance, std::size_t mostSteps);

} // namespace shadowlab::radiosity
