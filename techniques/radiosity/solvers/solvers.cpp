// SPDX-License-Identifier: MIT
#include "techniques/radiosity/solvers/solvers.h"

#include <algorithm>
#include <string>
#include <utility>

#include "techniques/foundation/base/error.h"
#include "techniques/radiosity/solvers/solver_kinds.h"

namespace shadowlab::radiosity {

namespace {

double largestOf(const dvec3& colour) { return std::max({colour.x, colour.y, colour.z}); }

} // namespace

std::string_view nameOf(SolverKind kind) {
    switch (kind) {
    case SolverKind::direct: return "direct";
    case SolverKind::jacobi: return "jacobi";
    case SolverKind::gaussSeidel: return "gauss-seidel";
    case SolverKind::southwell: return "southwell";
    case SolverKind::shooting: return "shooting";
    case SolverKind::conjugateGradients: break;
    }
    return "conjugate-gradients";
}

void requireFewPatches(SolverKind kind, std::size_t patches) {
    if (kind == SolverKind::direct && patches > kMostPatchesDirect)
        throw Error(ExitStatus::overLimit, "radiosity: the direct solver takes at most " +
                                               std::to_string(kMostPatchesDirect) + " patches, and there are " +
                                               std::to_string(patches) +
                                               "; choose conjugate-gradients, or larger patches");
}

std::unique_ptr<Solver> makeSolver(SolverKind kind, Problem problem) {
    requireFewPatches(kind, problem.exchange.size());
    switch (kind) {
    case SolverKind::direct: return makeDirect(std::move(problem));
    case SolverKind::jacobi: return makeJacobi(std::move(problem));
    case SolverKind::gaussSeidel: return makeGaussSeidel(std::move(problem));
    case SolverKind::southwell: return makeSouthwell(std::move(problem));
    case SolverKind::shooting: return makeShooting(std::move(problem));
    case SolverKind::conjugateGradients: break;
    }
    return makeConjugateGradients(std::move(problem));
}

bool isSolved(const Solver& solver, double tolerance) {
    double largest = 0;
    for (const dvec3& value : solver.radiosity())
        largest = std::max(largest, largestOf(value));
    return largestOf(solver.errorBound().largest) <= tolerance * largest;
}

bool solve(Solver& solver, double tolerance, std::size_t mostSteps) {
    for (std::size_t i = 0; i < mostSteps && !isSolved(solver, tolerance); ++i)
        solver.step();
    return isSolved(solver, tolerance);
}

} // namespace shadowlab::radiosity
