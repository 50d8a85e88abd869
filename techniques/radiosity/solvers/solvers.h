// Six ways to solve the radiosity equations. Each works step by step, so that a room can be shown while it is solved, and gives a
// bound of its error after every step.
//
//   direct               Cholesky on the symmetrised system: one step, whatever the reflectances are; for up to 3000 patches
//   jacobi               one more bounce of all the light with every sweep
//   gauss-seidel         as Jacobi, but each patch already uses the new values of those before it: about half the sweeps
//   southwell            one patch per step: the one with the largest residual
//   shooting             progressive refinement: one patch per step shoots all its unshot light
//   conjugate-gradients  on the symmetrised system: few sweeps even where nearly all light is reflected
//
// With q = max rho_i sum_j F_ij, a sweep of Jacobi or Gauss-Seidel divides the error by about 1/q: at rho = .999 they need 14,000
// (7000) for six digits. Conjugate gradients need many only where the eigenvalues of rho F are spread out, which in rooms they
// are not.
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

/// The name in the list above.
std::string_view nameOf(SolverKind kind);

/// The direct solver takes at most so many patches: its factor takes 72 MB for each colour, and some ten seconds.
constexpr std::size_t kMostPatchesDirect = 3000;

/// A solution in progress. It may stop after any step and continue later; every intermediate state is valid. The same steps give
/// the same bits on any number of threads.
class Solver {
public:
    virtual ~Solver() = default;
    Solver(const Solver&) = delete;
    Solver& operator=(const Solver&) = delete;

    /// One sweep over all patches, or one shot: the work of at most two products with the matrix, except for the first step of
    /// the direct solver, which factorises.
    void step() {
        advance();
        ++steps_;
    }
    [[nodiscard]] std::size_t steps() const { return steps_; }

    /// B_i, W/m^2.
    [[nodiscard]] virtual const std::vector<dvec3>& radiosity() const = 0;
    /// E + rho F B - B, W/m^2. For shooting it takes a product with the matrix; otherwise it is stored.
    [[nodiscard]] virtual std::vector<dvec3> residual() const = 0;
    /// How far `radiosity` is from the solution at most (proof in iterate.h).
    [[nodiscard]] virtual ErrorBound errorBound() const = 0;
    /// The power that was received and not yet shot, W; only for shooting.
    [[nodiscard]] virtual std::optional<dvec3> unshotPower() const { return std::nullopt; }
    /// What to display, W/m^2: for shooting, with the ambient term. It is an estimate: no step uses it, and the error bound does
    /// not cover it.
    [[nodiscard]] virtual std::vector<dvec3> shown() const { return radiosity(); }

protected:
    Solver() = default;

private:
    virtual void advance() = 0;
    std::size_t steps_ = 0;
};

/// Throws Error (overLimit) for more patches than the direct solver takes. Called before form factors are computed in vain.
void requireFewPatches(SolverKind kind, std::size_t patches);

/// Throws Error: badInput with what `refusal` says of the problem, overLimit as above.
std::unique_ptr<Solver> makeSolver(SolverKind kind, Problem problem);

/// Is the error of every colour proven to be at most `tolerance` times the largest B of all patches and colours? This is the
/// stopping rule. A small residual, or little unshot power, would not do: it says nothing where nearly all light is reflected.
bool isSolved(const Solver& solver, double tolerance);

/// Steps until `isSolved`, or `mostSteps` times. Returns whether it is solved.
bool solve(Solver& solver, double tolerance, std::size_t mostSteps);

} // namespace shadowlab::radiosity
