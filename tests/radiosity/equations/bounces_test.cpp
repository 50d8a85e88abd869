// Light bounce by bounce, and where its power goes.
// SPDX-License-Identifier: MIT
#include "techniques/radiosity/equations/bounces.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "techniques/radiosity/solvers/solvers.h"
#include "tests/radiosity/rooms.h"

namespace shadowlab::radiosity {
namespace {

TEST(RadiosityBounces, AddUpToJacobisSweepsAndToTheSolution) {
    const testing::Room room = testing::cube(.2, .5, .8);
    const Problem problem = room.problem();
    const auto jacobi = makeSolver(SolverKind::jacobi, problem);
    const auto exact = testing::eliminated(problem);
    std::vector<dvec3> sum(6, dvec3(0)), step = bounce(problem, 0);
    EXPECT_EQ(step, problem.emission);
    int compared = 0;
    for (std::size_t k = 0; k < 60; ++k) {
        const std::vector<dvec3> light = bounce(problem, k);
        jacobi->step();
        for (std::size_t i = 0; i < 6; ++i) {
            EXPECT_EQ(light[i], step[i]) << k;
            sum[i] += light[i];
            EXPECT_NEAR(jacobi->radiosity()[i].x, sum[i].x, 1e-14) << k; // some 60 roundings of numbers near 1
            ++compared;
        }
        step = nextBounce(problem, step);
    }
    EXPECT_EQ(compared, 360);
    for (std::size_t i = 0; i < 6; ++i)
        EXPECT_NEAR(sum[i].x, static_cast<double>(exact[i][0]), 1e-12); // 0.8^60 is 1.5e-6, but the means are near .5
    // A patch that does not emit gets its first light from the first bounce, no sooner.
    EXPECT_EQ(bounce(problem, 0)[1].x, 0);
    EXPECT_DOUBLE_EQ(bounce(problem, 1)[1].x, .8 * testing::oppositeInCube());
}

TEST(RadiosityBounces, WhereAllIsEqualEachBounceIsDimmerByTheReflectance) {
    testing::Room room = testing::cube(.7, .7, .7);
    room.emission.assign(6, dvec3(3));
    for (const std::size_t k : {0, 1, 2, 10, 100})
        for (const dvec3& value : bounce(room.problem(), k)) {
            const double expected = 3 * std::pow(.7, static_cast<double>(k));
            // Each bounce rounds some eight times.
            EXPECT_NEAR(value.x, expected, 8e-16 * static_cast<double>(k + 1) * expected) << k;
        }
}

TEST(RadiosityEnergy, WhatIsEmittedIsAbsorbedAndWithBInPlaceOfHItIsNot) {
    const testing::Room room = testing::cube(.2, .5, .8);
    const auto solver = makeSolver(SolverKind::direct, room.problem());
    solver->step();
    const EnergyBalance balance = energyBalance(room.problem(), solver->radiosity());
    EXPECT_EQ(balance.emitted.x, 1);
    EXPECT_LE(std::abs(balance.closedResidual().x), 1e-10);
    EXPECT_LE(std::abs(balance.residual().x), 1e-10);
    double naive = 0;
    for (std::size_t i = 0; i < 6; ++i)
        naive += room.areas[i] * (1 - room.reflectance[i].x) * solver->radiosity()[i].x;
    EXPECT_NEAR(naive, 1.2713, 5e-5) << "a fourth too much"; // given to five digits

    // With one reflectance for all, the wrong formula gives the right number: a test with such a room sees nothing.
    const testing::Room grey = testing::cube(.5, .5, .5);
    const auto greySolver = makeSolver(SolverKind::direct, grey.problem());
    greySolver->step();
    double hidden = 0;
    for (const dvec3& value : greySolver->radiosity())
        hidden += 0.5 * value.x;
    EXPECT_NEAR(hidden, 1, 1e-14);
}

// All kinds of rooms: what is not absorbed escapes. Where q is above 1 - 1e-4, rounding of the largest radiosities (1e-15 / (1 - q))
// comes into the range of the figure, so that these rooms are left to the test of the bound.
TEST(RadiosityEnergy, NothingIsLostInAnyRoom) {
    int closed = 0, open = 0, escapes = 0, shots = 0;
    for (std::uint64_t seed = 1; seed <= 1000; ++seed) {
        const testing::Room room = testing::randomRoom(seed);
        const Problem problem = room.problem();
        const dvec3 q = reflectionBounds(problem).ofLargest;
        if (std::max({q.x, q.y, q.z}) > 1 - 1e-4) continue;
        const bool isClosed = std::ranges::all_of(closureDeficits(room.exchange, room.areas),
                                                  [](double deficit) { return std::abs(deficit) < 1e-11; });
        for (const SolverKind kind : {SolverKind::direct, SolverKind::conjugateGradients}) {
            const auto solver = makeSolver(kind, problem);
            ASSERT_TRUE(solve(*solver, 1e-10, 200)) << nameOf(kind) << " " << seed;
            while (solver->steps() < 60 && kind != SolverKind::direct)
                solver->step(); // far enough for what is faintest, too
            const EnergyBalance balance = energyBalance(problem, solver->radiosity());
            for (int c = 0; c < 3; ++c) {
                EXPECT_LE(std::abs(balance.residual()[c]), 1e-10) << nameOf(kind) << " " << seed;
                if (isClosed) {
                    EXPECT_LE(std::abs(balance.closedResidual()[c]), 1e-10) << seed;
                }
                escapes += balance.escaped[c] > 0.01 * balance.emitted[c];
            }
        }
        // Half-way, what is missing is no more than the bound of the power allows.
        const auto shooting = makeSolver(SolverKind::shooting, problem);
        for (int i = 0; i < 20; ++i) {
            shooting->step();
            const EnergyBalance balance = energyBalance(problem, shooting->radiosity());
            const dvec3 missing = glm::abs(balance.emitted - balance.absorbed - balance.escaped);
            for (int c = 0; c < 3; ++c) {
                // It is sum A_i e_i (1 - mean reflectance of what i sees), for the errors e.
                EXPECT_LE(missing[c], (1 + 1e-12) * shooting->errorBound().power[c] + 1e-13 * balance.emitted[c])
                    << seed;
                ++shots;
            }
        }
        ++(isClosed ? closed : open);
    }
    EXPECT_GT(closed, 30);
    EXPECT_GT(open, 60);
    EXPECT_GT(escapes, 60);
    EXPECT_GT(shots, 3000);
}

} // namespace
} // namespace shadowlab::radiosity
