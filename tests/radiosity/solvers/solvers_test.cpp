// What all solvers have in common, and what is special about each.
// SPDX-License-Identifier: MIT
#include "techniques/radiosity/solvers/solvers.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "techniques/foundation/base/error.h"
#include "techniques/radiosity/equations/bounces.h"
#include "tests/radiosity/rooms.h"

namespace shadowlab::radiosity {
namespace {

/// The largest difference of any patch and colour, as a share of the largest radiosity of that colour.
double difference(const std::vector<dvec3>& a, const std::vector<dvec3>& b) {
    dvec3 largest(0), most(0);
    for (std::size_t i = 0; i < a.size(); ++i) {
        most = glm::max(most, glm::abs(a[i] - b[i]));
        largest = glm::max(largest, b[i]);
    }
    double share = 0;
    for (int c = 0; c < 3; ++c)
        if (most[c] > 0) share = std::max(share, most[c] / largest[c]);
    return share;
}

testing::Room colouredCube(std::size_t n) {
    testing::Room room = testing::subdividedCube(n);
    for (std::size_t i = 0; i < room.size(); ++i) {
        const double share = static_cast<double>(i) / static_cast<double>(room.size());
        room.reflectance[i] = dvec3(0.9, 0.5 + 0.4 * share, i % 5 == 0 ? 0.0 : 0.95 * (1 - share));
        room.emission[i] *= dvec3(1, 0.5, 2);
    }
    return room;
}

TEST(RadiositySolvers, AllComeToTheSame) {
    // 1e-5 is what is asked for, 1e-7 what they were told to stop by; elimination in long double is the judge of the direct one.
    int compared = 0, rooms = 0;
    const auto compareIn = [&](const testing::Room& room) {
        const auto direct = makeSolver(SolverKind::direct, room.problem());
        direct->step();
        direct->step();
        std::vector<dvec3> exact;
        for (const testing::Longs& value : testing::eliminated(room.problem()))
            exact.emplace_back(static_cast<double>(value[0]), static_cast<double>(value[1]),
                               static_cast<double>(value[2]));
        EXPECT_LE(difference(direct->radiosity(), exact), 1e-13); // rounding, over 1 - rho of at least 0.01
        for (const SolverKind kind : kSolverKinds) {
            const auto solver = makeSolver(kind, room.problem());
            ASSERT_TRUE(solve(*solver, 1e-7, 200'000)) << nameOf(kind);
            EXPECT_LE(difference(solver->radiosity(), direct->radiosity()), 1e-5) << nameOf(kind);
            ++compared;
        }
        ++rooms;
    };
    for (const std::size_t n : {1, 3, 5})
        compareIn(colouredCube(n));
    for (std::uint64_t seed = 1; seed <= 300; ++seed) {
        testing::Room room = testing::randomRoom(seed);
        const dvec3 q = reflectionBounds(room.problem()).ofLargest;
        if (std::max({q.x, q.y, q.z}) > 0.99) continue;
        for (dvec3& value : room.emission)
            value = dvec3(value.x + value.y +
                          value.z); // no colour much fainter than another: the brightest one is the measure
        compareIn(room);
    }
    EXPECT_GT(rooms, 30);
    EXPECT_EQ(compared, rooms * 6);
}

TEST(RadiositySolvers, TheResidualIsThatOfTheRadiosityShown) {
    const testing::Room room = colouredCube(3);
    const Problem problem = room.problem();
    int compared = 0;
    for (const SolverKind kind : kSolverKinds) {
        const auto solver = makeSolver(kind, problem);
        EXPECT_EQ(solver->steps(), 0u);
        for (int step = 1; step <= 40; ++step) {
            solver->step();
            const std::vector<dvec3> reflected = nextBounce(problem, solver->radiosity()),
                                     residual = solver->residual();
            for (std::size_t i = 0; i < room.size(); ++i)
                for (int c = 0; c < 3; ++c) {
                    const double expected = problem.emission[i][c] + reflected[i][c] - solver->radiosity()[i][c];
                    ASSERT_NEAR(residual[i][c], expected, 1e-13) << nameOf(kind) << " step " << step; // B is up to 20
                    ++compared;
                }
        }
        EXPECT_EQ(solver->steps(), 40u);
        EXPECT_EQ(solver->unshotPower().has_value(), kind == SolverKind::shooting);
    }
    EXPECT_EQ(compared, 6 * 40 * 54 * 3);
}

TEST(RadiositySolvers, TheSameBitsOnAnyNumberOfThreadsAndWhoeverLooksOn) {
    const testing::Room room = colouredCube(10); // six pieces of rows
    const char* const before = std::getenv("SHADOWLAB_THREADS");
    const std::string kept = before ? before : "";
    int compared = 0;
    for (const SolverKind kind : kSolverKinds) {
        std::vector<std::vector<dvec3>> results;
        for (const char* threads : {"1", "2", "7"}) {
            setenv("SHADOWLAB_THREADS", threads, 1);
            const auto solver = makeSolver(kind, room.problem());
            for (int i = 0; i < (kind == SolverKind::direct ? 1 : 9); ++i) {
                solver->step();
                if (results.empty()) continue; // the first is left alone, the others are looked at
                (void)solver->shown();
                (void)solver->residual();
                (void)solver->errorBound();
                (void)solver->unshotPower();
            }
            results.push_back(solver->radiosity());
        }
        EXPECT_EQ(results[0], results[1]) << nameOf(kind);
        EXPECT_EQ(results[0], results[2]) << nameOf(kind);
        ++compared;
    }
    EXPECT_EQ(compared, 6);
    if (before)
        setenv("SHADOWLAB_THREADS", kept.c_str(), 1);
    else
        unsetenv("SHADOWLAB_THREADS");
}

TEST(RadiositySolvers, SurfacesThatReflectNothingShowWhatTheyEmit) {
    testing::Room room = testing::cube(0, 0, 0);
    testing::Room nearly = testing::cube(1e-310, 0, 1e-200); // numbers that cannot be multiplied by themselves
    nearly.reflectance[3] = dvec3(0.5);
    const auto exact = testing::eliminated(nearly.problem());
    int compared = 0;
    for (const SolverKind kind : kSolverKinds) {
        const auto black = makeSolver(kind, room.problem());
        EXPECT_TRUE(solve(*black, 1e-14, 20)) << nameOf(kind);
        EXPECT_EQ(black->radiosity(), room.emission) << nameOf(kind);
        const auto dim = makeSolver(kind, nearly.problem());
        EXPECT_TRUE(solve(*dim, 1e-13, 50)) << nameOf(kind);
        for (std::size_t i = 0; i < 6; ++i)
            EXPECT_NEAR(dim->radiosity()[i].x, static_cast<double>(exact[i][0]), 1e-13) << nameOf(kind);
        ++compared;
    }
    EXPECT_EQ(compared, 6);
}

// A hollow ball that is one patch sees nothing but itself, F = 1: its own equation is all there is, and one step solves it.
TEST(RadiositySolvers, APatchThatSeesItselfIsAccountedFor) {
    const testing::Room ball = testing::sphereInside({2.0}, {dvec3(1, 2, 0)}, {dvec3(.999, .5, 1)});
    for (const SolverKind kind :
         {SolverKind::direct, SolverKind::gaussSeidel, SolverKind::southwell, SolverKind::conjugateGradients}) {
        const auto solver = makeSolver(kind, ball.problem());
        solver->step();
        EXPECT_NEAR(solver->radiosity()[0].x, 1000, 1e-9) << nameOf(kind); // 1e-16 / (1 - rho), times 1000
        EXPECT_NEAR(solver->radiosity()[0].y, 4, 1e-14) << nameOf(kind);
        EXPECT_EQ(solver->radiosity()[0].z, 0) << nameOf(kind) << ": nothing emits it, and all of it would be kept";
        EXPECT_EQ(solver->errorBound().largest.z, 0) << nameOf(kind);
    }
    const auto jacobi = makeSolver(SolverKind::jacobi, ball.problem()); // takes it for one more patch
    jacobi->step();
    EXPECT_EQ(jacobi->radiosity()[0].x, 1);
}

TEST(RadiositySolvers, GoOnFromWhereNothingIsLeftToGain) {
    // Conjugate gradients, taken literally, lead away again once all that is left is rounding: to 10^300 in some thousand steps.
    int compared = 0;
    for (std::uint64_t seed = 1; seed <= 400; ++seed) {
        const testing::Room room = testing::randomRoom(seed);
        const dvec3 q = reflectionBounds(room.problem()).ofLargest;
        if (std::max({q.x, q.y, q.z}) > 0.999) continue;
        for (const SolverKind kind : {SolverKind::conjugateGradients, SolverKind::gaussSeidel}) {
            const auto solver = makeSolver(kind, room.problem());
            const std::size_t enough = kind == SolverKind::gaussSeidel ? 40'000 : 60;
            if (!solve(*solver, 1e-11, enough)) ADD_FAILURE() << nameOf(kind) << " " << seed;
            for (int i = 0; i < 200; ++i) {
                solver->step();
                ASSERT_TRUE(isSolved(*solver, 1e-11)) << nameOf(kind) << " room " << seed << " " << i << " steps later";
            }
            ++compared;
        }
    }
    EXPECT_GT(compared, 100);
}

TEST(RadiositySolvers, ADirectSolutionIsRefusedWhereItWouldTakeTooLong) {
    const ExchangeMatrix exchange(kMostPatchesDirect + 1);
    const std::vector<dvec3> colours(exchange.size(), dvec3(0.5));
    const Problem problem{exchange, std::vector(exchange.size(), 1.0), colours, colours};
    try {
        (void)makeSolver(SolverKind::direct, problem);
        FAIL() << "not refused";
    } catch (const Error& error) {
        EXPECT_EQ(error.status(), ExitStatus::overLimit);
        EXPECT_STREQ(error.what(),
                     "radiosity: the direct solver takes at most 3000 patches, and there are 3001; choose "
                     "conjugate-gradients, or larger patches");
    }
}

TEST(RadiosityShooting, BrightensShotByShotAndNeverTooMuch) {
    const testing::Room room = colouredCube(4);
    const auto exact = testing::eliminated(room.problem());
    const auto solver = makeSolver(SolverKind::shooting, room.problem());
    std::vector<dvec3> before = solver->radiosity();
    EXPECT_EQ(before, room.emission);
    dvec3 bound = solver->errorBound().power;
    int brighter = 0, compared = 0;
    for (int shot = 0; shot < 2000; ++shot) {
        solver->step();
        for (std::size_t i = 0; i < room.size(); ++i)
            for (int c = 0; c < 3; ++c) {
                const double now = solver->radiosity()[i][c];
                // x + unshot, each rounded: a few 1e-16 of B, which is at most 10
                ASSERT_GE(now, before[i][c] - 1e-14) << shot;
                ASSERT_LE(now, static_cast<double>(exact[i][c]) + 1e-13) << shot;
                brighter += now > before[i][c] + 1e-12;
                ++compared;
            }
        const dvec3 boundNow = solver->errorBound().power;
        for (int c = 0; c < 3; ++c)
            ASSERT_LE(boundNow[c], bound[c] * (1 + 1e-9) + 1e-12)
                << "the power left falls with every shot, at " << shot;
        bound = boundNow;
        before = solver->radiosity();
    }
    EXPECT_EQ(compared, 2000 * 96 * 3);
    EXPECT_GT(brighter, 50'000);
}

TEST(RadiosityShooting, TheAmbientTermIsAnEstimateAndNoMore) {
    // Inside a sphere light does spread evenly, and the estimate is the solution, before the first shot.
    std::vector<dvec3> emission = {dvec3(1), dvec3(0), dvec3(.5), dvec3(0), dvec3(2)};
    std::vector<dvec3> reflectance = {dvec3(.9), dvec3(.5), dvec3(.2), dvec3(.7), dvec3(.3)};
    const testing::Room sphere = testing::sphereInside({.1, .2, .3, .25, .15}, emission, reflectance);
    const auto inside = makeSolver(SolverKind::shooting, sphere.problem());
    EXPECT_NEAR(inside->shown()[0].x, 1.9339622641509435, 1e-14);
    EXPECT_NEAR(inside->shown()[1].x, .5188679245283019, 1e-14);
    EXPECT_EQ(inside->radiosity()[1].x, 0) << "it is no part of the solution";

    // Elsewhere it is nearer than what was shot so far, and vanishes with it.
    const testing::Room room = testing::cube(.9, .9, .9);
    const auto exact = testing::eliminated(room.problem());
    const auto solver = makeSolver(SolverKind::shooting, room.problem());
    const auto errorOf = [&](const std::vector<dvec3>& radiosity) {
        double error = 0;
        for (std::size_t i = 0; i < 6; ++i)
            error += std::abs(static_cast<double>(exact[i][0]) - radiosity[i].x);
        return error;
    };
    for (int shot = 0; shot < 100; ++shot) {
        EXPECT_LT(errorOf(solver->shown()), 0.25 * errorOf(solver->radiosity())) << shot;
        solver->step();
    }
    while (!isSolved(*solver, 1e-12))
        solver->step();
    EXPECT_LT(difference(solver->shown(), solver->radiosity()), 1e-11);

    // In an open scene much escapes: the estimate knows, and 1 / (1 - mean rho) for white surfaces would be infinite.
    testing::Room open = testing::cube(1, 1, 1);
    for (std::size_t j = 0; j < 6; ++j)
        if (j != 1) open.exchange.set(1, j, 0);
    const auto white = makeSolver(SolverKind::shooting, open.problem());
    for (const dvec3& value : white->shown())
        EXPECT_TRUE(value.x >= 0 && value.x < 10) << value.x;
}

} // namespace
} // namespace shadowlab::radiosity
