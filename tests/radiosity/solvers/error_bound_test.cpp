// The printed bound of the error against the true error, in rooms of all kinds, after every step of every solver.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "techniques/radiosity/solvers/solvers.h"
#include "tests/radiosity/rooms.h"

namespace shadowlab::radiosity {
namespace {

struct TrueError {
    testing::Longs largest{}, power{};
};

TrueError trueError(const Problem& problem, const std::vector<testing::Longs>& exact,
                    const std::vector<dvec3>& radiosity) {
    TrueError error;
    for (std::size_t i = 0; i < exact.size(); ++i)
        for (int c = 0; c < 3; ++c) {
            const long double here = std::abs(exact[i][c] - radiosity[i][c]);
            error.largest[c] = std::max(error.largest[c], here);
            error.power[c] += problem.areas[i] * here;
        }
    return error;
}

/// How many steps show a solver from its first to what doubles can give, or a good part of that way.
std::size_t stepsOf(SolverKind kind, std::size_t patches) {
    switch (kind) {
    case SolverKind::direct: return 3;
    case SolverKind::southwell:
    case SolverKind::shooting: return 20 + 6 * patches;
    default: return 50;
    }
}

// A true bound holds always: no tolerance. The exact solution is known to some 1e-19 n / (1 - q), the bound cannot fall
// below 1e-16 / (1 - q), so that the one can stand for the truth.
TEST(RadiosityErrorBound, NoErrorExceedsItInAThousandRooms) {
    std::map<SolverKind, int> compared, isAtRounding;
    int rooms = 0, nearlyWhite = 0, open = 0, naiveResidual = 0, naiveRounding = 0, dark = 0;
    double sharpest = 1e300;
    for (std::uint64_t seed = 1; seed <= 1000; ++seed) {
        const testing::Room room = testing::randomRoom(seed);
        const Problem problem = room.problem();
        ASSERT_EQ(refusal(problem), std::nullopt) << seed;
        const auto exact = testing::eliminated(problem);
        const dvec3 q = reflectionBounds(problem).ofLargest;
        ++rooms;
        nearlyWhite += glm::any(glm::greaterThan(q, dvec3(0.9999)));
        open += std::ranges::min(rowSums(room.exchange, room.areas)) < 0.99;
        for (const SolverKind kind : kSolverKinds) {
            const auto solver = makeSolver(kind, problem);
            for (std::size_t step = 0; step <= stepsOf(kind, room.size()); ++step) {
                if (step > 0) solver->step();
                const ErrorBound bound = solver->errorBound();
                const TrueError error = trueError(problem, exact, solver->radiosity());
                const auto residual = solver->residual();
                for (int c = 0; c < 3; ++c) {
                    ASSERT_LE(error.largest[c], bound.largest[c])
                        << nameOf(kind) << " room " << seed << " step " << step;
                    ASSERT_LE(error.power[c], bound.power[c]) << nameOf(kind) << " room " << seed << " step " << step;
                    ++compared[kind];
                    if (bound.largest[c] == 0) {
                        ++dark;
                        continue;
                    }
                    double largest = 0, brightest = 0;
                    for (const dvec3& value : residual)
                        largest = std::max(largest, std::abs(value[c]));
                    for (const dvec3& value : solver->radiosity())
                        brightest = std::max(brightest, value[c]);
                    isAtRounding[kind] += bound.largest[c] * (1 - q[c]) < 1e-14 * brightest;
                    // What naive programs print: the residual itself, and the bound as it is without rounding.
                    naiveResidual += error.largest[c] > largest;
                    naiveRounding += error.largest[c] > largest / (1 - q[c]);
                    if (error.largest[c] > 1e-6L * brightest)
                        sharpest = std::min(sharpest, static_cast<double>(bound.largest[c] / error.largest[c]));
                }
            }
        }
    }
    EXPECT_EQ(rooms, 1000);
    EXPECT_GT(nearlyWhite, 300);
    EXPECT_GT(open, 150);
    EXPECT_GT(dark, 1000) << "colours that nothing emits have no error at all";
    for (const SolverKind kind : kSolverKinds)
        EXPECT_GT(compared[kind], 10'000) << nameOf(kind);
    for (const SolverKind kind : {SolverKind::direct, SolverKind::conjugateGradients})
        EXPECT_GT(isAtRounding[kind], 1000) << nameOf(kind) << " has to come to where rounding is all that is left";
    EXPECT_GT(naiveResidual, 100'000) << "a residual is no bound";
    EXPECT_GT(naiveRounding, 1000) << "without rounding there is no bound at the end";
    EXPECT_LT(sharpest, 1.001) << "in some rooms the bound is the error itself: nothing was given away";
    RecordProperty("sharpest", std::to_string(sharpest));
}

} // namespace
} // namespace shadowlab::radiosity
