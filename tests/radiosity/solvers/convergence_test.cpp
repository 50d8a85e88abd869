// How many steps the solvers need, and what becomes of a program that stops by the wrong sign.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

#include "techniques/radiosity/solvers/solvers.h"
#include "tests/radiosity/rooms.h"

namespace shadowlab::radiosity {
namespace {

using Rule = std::function<bool(const Solver&)>;

/// From B = 0 (whose step is not counted) until the rule says stop.
std::size_t stepsUntil(SolverKind kind, const Problem& problem, const Rule& stop) {
    const auto solver = makeSolver(kind, problem);
    while (!stop(*solver) && solver->steps() < 100'000)
        solver->step();
    return solver->steps();
}

/// Each patch is right to a millionth of its own radiosity.
Rule everyPatchIsRight(const Problem& problem) {
    return [exact = testing::eliminated(problem)](const Solver& solver) {
        for (std::size_t i = 0; i < exact.size(); ++i)
            if (std::abs(exact[i][0] - solver.radiosity()[i].x) > 1e-6L * exact[i][0]) return false;
        return true;
    };
}

double largest(const std::vector<dvec3>& values) {
    double most = 0;
    for (const dvec3& value : values)
        most = std::max({most, std::abs(value.x), std::abs(value.y), std::abs(value.z)});
    return most;
}

/// The largest residual is a millionth of the largest radiosity: a rule that looks right and is not.
bool residualIsSmall(const Solver& solver) { return largest(solver.residual()) <= 1e-6 * largest(solver.radiosity()); }

// Six patches, the floor emits and comes first: counts that were found by other programs, to the step. Each patch has to be right
// to a millionth of its own radiosity. Jacobi's first sweep, which makes B = E of B = 0, is not counted; the others begin with 0.
TEST(RadiosityConvergence, SimpleSolversNeedThousandsOfSweepsInWhiteRooms) {
    struct Case {
        double reflectance;
        std::size_t jacobi, gaussSeidel, southwell, southwellBySmallResidual;
    };
    int compared = 0;
    for (const Case& c : {Case{.99, 1375, 689, 4133, 2947}, Case{.999, 13809, 6906, 41435, 22783}}) {
        const testing::Room room = testing::cube(c.reflectance, c.reflectance, c.reflectance);
        const Problem problem = room.problem();
        const Rule isRight = everyPatchIsRight(problem);
        EXPECT_EQ(stepsUntil(SolverKind::jacobi, problem, isRight) - 1, c.jacobi);
        EXPECT_EQ(stepsUntil(SolverKind::gaussSeidel, problem, isRight), c.gaussSeidel);
        EXPECT_EQ(stepsUntil(SolverKind::southwell, problem, isRight), c.southwell);
        EXPECT_EQ(stepsUntil(SolverKind::southwell, problem, residualIsSmall), c.southwellBySmallResidual);
        ++compared;
    }
    EXPECT_EQ(compared, 2);
}

// The smaller count of Southwell's is bought: where the residual is small, the error is not.
TEST(RadiosityConvergence, ASmallResidualStopsSouthwellTooEarly) {
    const testing::Room room = testing::cube(.999, .999, .999);
    const auto solver = makeSolver(SolverKind::southwell, room.problem());
    while (!residualIsSmall(*solver))
        solver->step();
    const auto exact = testing::eliminated(room.problem());
    const double error = static_cast<double>(std::abs(exact[0][0] - solver->radiosity()[0].x) / exact[0][0]);
    EXPECT_GT(error, 400e-6) << "400 times what the rule seemed to promise";
    EXPECT_LE(error * static_cast<double>(exact[0][0]), solver->errorBound().largest.x) << "the bound knows";
    EXPECT_FALSE(isSolved(*solver, 400e-6));
}

// Here all of the unshot power will be reflected 999 times before it is gone.
TEST(RadiosityConvergence, LittleUnshotPowerIsNotLittleError) {
    const testing::Room room = testing::cube(.999, .999, .999);
    const auto exact = testing::eliminated(room.problem());
    const auto solver = makeSolver(SolverKind::shooting, room.problem());
    while (solver->unshotPower()->x > 1e-6) // of 1 W
        solver->step();
    long double error = 0;
    for (std::size_t i = 0; i < exact.size(); ++i)
        error += room.areas[i] * std::abs(exact[i][0] - solver->radiosity()[i].x);
    const double unshot = solver->unshotPower()->x, bound = solver->errorBound().power.x;
    EXPECT_NEAR(static_cast<double>(error) / unshot, 999, 0.01)
        << "rho / (1 - rho)"; // sums of 1 rounded at 1e-13 / 1e-6
    EXPECT_GT(static_cast<double>(error), 900e-6) << "the naive rule promised 1e-6";
    EXPECT_LE(static_cast<double>(error), bound);
    // Rounding may add a fourth of the residual to it before the residual is computed anew.
    EXPECT_LT(bound, 1.3 * static_cast<double>(error)) << "and the bound is no exaggeration";
}

TEST(RadiosityConvergence, ConjugateGradientsNeedFewStepsHoweverWhiteTheRoom) {
    int rooms = 0;
    std::size_t most = 0, patches = 0;
    const auto stepsFor = [&](const testing::Room& room) {
        ++rooms;
        patches = std::max(patches, room.size());
        const std::size_t steps = stepsUntil(SolverKind::conjugateGradients, room.problem(),
                                             [](const Solver& solver) { return largest(solver.residual()) <= 1e-10; });
        most = std::max(most, steps);
        EXPECT_LE(steps, 30u) << room.size();
        return steps;
    };
    for (const std::size_t n : {1, 2, 4, 8, 18}) {
        testing::Room room = testing::subdividedCube(n);
        ASSERT_NEAR(std::ranges::max(rowSums(room.exchange, room.areas)), 1, 1e-9) << n;
        room.reflectance.assign(room.size(), dvec3(.999));
        stepsFor(room);
        for (std::size_t i = 0; i < room.size(); i += 3)
            room.reflectance[i] = dvec3(0, .3, .9); // and where one in three patches is dark
        stepsFor(room);
    }
    for (const std::size_t size : {6, 60, 600}) {
        std::vector<double> areas;
        std::vector<dvec3> emission(size, dvec3(0));
        for (std::size_t i = 0; i < size; ++i)
            areas.push_back(1 + static_cast<double>(i % 7));
        emission[0] = dvec3(1);
        // Inside a sphere rho F has one eigenvalue that is not 0, and the preconditioner seven values, as the areas have: eight
        // eigenvalues in all, and a step for each.
        EXPECT_LE(stepsFor(testing::sphereInside(areas, emission, std::vector(size, dvec3(.999)))), 8u);
    }
    EXPECT_EQ(rooms, 13);
    EXPECT_EQ(patches, 6u * 18 * 18);
    EXPECT_GT(most, 5u) << "the rooms were not all trivial";
    RecordProperty("most", std::to_string(most));

    // What Jacobi has after as many steps.
    const testing::Room room = testing::cube(.999, .999, .999);
    const auto jacobi = makeSolver(SolverKind::jacobi, room.problem());
    EXPECT_FALSE(solve(*jacobi, 0.5, 30)) << "not even half of it";
}

} // namespace
} // namespace shadowlab::radiosity
