// Problems that have no solution, or none with a bound of its error, are refused; those that only look so are not.
// SPDX-License-Identifier: MIT
#include "techniques/radiosity/equations/problem.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>

#include "techniques/foundation/base/error.h"
#include "techniques/radiosity/solvers/solvers.h"
#include "tests/radiosity/rooms.h"

namespace shadowlab::radiosity {
namespace {

TEST(RadiosityProblem, AWhiteClosedRoomWithALightIsRefused) {
    const testing::Room room = testing::cube(1, 1, 1);
    const auto why = refusal(room.problem());
    ASSERT_TRUE(why);
    EXPECT_NE(why->find("never dies out"), std::string::npos) << *why;
    EXPECT_NE(why->find("give one surface a reflectance below 1"), std::string::npos) << *why;
    EXPECT_EQ(why->find('\n'), std::string::npos);
    int refused = 0;
    for (const SolverKind kind : kSolverKinds)
        try {
            (void)makeSolver(kind, room.problem());
        } catch (const Error& error) {
            EXPECT_EQ(error.status(), ExitStatus::badInput);
            EXPECT_EQ(error.what(), "radiosity: " + *why);
            ++refused;
        }
    EXPECT_EQ(refused, 6);

    // What a program without the question does: it sweeps for ever, each sweep as bright as the one before.
    std::vector<dvec3> light = room.emission;
    double sum = 0;
    for (int sweep = 0; sweep < 1000; ++sweep) {
        std::vector<dvec3> next(6, dvec3(0));
        for (std::size_t i = 0; i < 6; ++i)
            for (std::size_t j = 0; j < 6; ++j)
                next[i] += room.exchange(i, j) * light[j];
        light = next;
        sum += light[3].x;
    }
    EXPECT_NEAR(sum, 1000.0 / 6, 1); // and no end to it
}

TEST(RadiosityProblem, TheLimitIsABillionthBelowOne) {
    EXPECT_TRUE(refusal(testing::cube(1 - 1e-10, 1 - 1e-10, 1 - 1e-10).problem()));
    const testing::Room room = testing::cube(1 - 1e-8, 1 - 1e-8, 1 - 1e-8);
    ASSERT_FALSE(refusal(room.problem()));
    const auto solver = makeSolver(SolverKind::conjugateGradients, room.problem());
    EXPECT_TRUE(solve(*solver, 1e-6, 30)); // rounding, 1e-15, over 1 - rho: 1e-7
    const auto exact = testing::eliminated(room.problem());
    EXPECT_NEAR(solver->radiosity()[1].x / static_cast<double>(exact[1][0]), 1, 1e-6);
    EXPECT_GT(solver->radiosity()[1].x, 1e7);
}

TEST(RadiosityProblem, OneWhiteSurfaceIsRefusedForWhatItIs) {
    const auto why = refusal(testing::cube(1, .5, .5).problem());
    ASSERT_TRUE(why);
    EXPECT_EQ(why->find("never dies out"), std::string::npos) << "which would not be true: " << *why;
    EXPECT_NE(why->find("no error has a bound"), std::string::npos) << *why;
}

TEST(RadiosityProblem, RowSumsAboveOneCountAsReflectance) {
    testing::Room room = testing::cube(.9, .9, .9); // with form factors of two points, pi/2 times too large
    for (std::size_t i = 0; i < 6; ++i)
        for (std::size_t j = 0; j < i; ++j)
            room.exchange.set(i, j, 1.59 * room.exchange(i, j));
    EXPECT_TRUE(refusal(room.problem())) << "its series diverges: 0.9 x 1.59";
}

TEST(RadiosityProblem, WhiteOpenScenesAndWhiteRoomsWithoutLightAreSolved) {
    testing::Room open = testing::cube(1, 1, 1);
    for (std::size_t j = 1; j < 6; ++j) { // the ceiling is taken away
        open.exchange.set(0, 1, 0);
        open.exchange.set(1, j, 0);
    }
    ASSERT_FALSE(refusal(open.problem()));
    testing::Room dark = testing::cube(1, 1, 1);
    for (dvec3& value : dark.emission)
        value = dvec3(0);
    testing::Room redOnly = testing::cube(1, 1, 1); // red dies out; of the others there is none
    redOnly.emission[0] = dvec3(1, 0, 0);
    for (dvec3& value : redOnly.reflectance)
        value.x = 0.5;
    ASSERT_FALSE(refusal(dark.problem()));
    ASSERT_FALSE(refusal(redOnly.problem()));
    int solvers = 0;
    for (const SolverKind kind : kSolverKinds) {
        const auto white = makeSolver(kind, open.problem());
        EXPECT_TRUE(solve(*white, 1e-9, 20'000)) << nameOf(kind);
        EXPECT_GT(white->radiosity()[3].x, 0.1);

        const auto black = makeSolver(kind, dark.problem());
        EXPECT_TRUE(isSolved(*black, 0)) << "before the first step";
        for (int i = 0; i < 5; ++i)
            black->step();
        EXPECT_EQ(black->radiosity(), std::vector(6, dvec3(0))) << nameOf(kind);
        EXPECT_EQ(black->errorBound().largest, dvec3(0)) << nameOf(kind);
        EXPECT_EQ(black->errorBound().power, dvec3(0)) << nameOf(kind);

        const auto red = makeSolver(kind, redOnly.problem());
        EXPECT_TRUE(solve(*red, 1e-10, 1000)) << nameOf(kind);
        EXPECT_NEAR(red->radiosity()[0].x, 1.09090909811, 1e-9) << nameOf(kind);
        for (const dvec3& value : red->radiosity())
            EXPECT_TRUE(value.y == 0 && value.z == 0) << nameOf(kind);
        ++solvers;
    }
    EXPECT_EQ(solvers, 6);
}

TEST(RadiosityProblem, BoundsOfReflection) {
    // Floor .2, walls .5, ceiling .8, row sums 1. From a wall one sees all of them but itself.
    const ReflectionBounds bounds = reflectionBounds(testing::cube(.2, .5, .8).problem());
    EXPECT_NEAR(bounds.ofLargest.x, .8, 1e-14); // rounding, which is in it on purpose
    EXPECT_GE(bounds.ofLargest.x, .8);
    const double fromFloor = .8 * testing::oppositeInCube() + 4 * .5 * testing::adjacentInCube();
    EXPECT_NEAR(bounds.ofPower.x, fromFloor, 1e-14);
    EXPECT_GT(bounds.ofPower.x, .5);
}

TEST(RadiosityProblem, WrongInputIsNamed) {
    const auto saysAfter = [](const std::function<void(testing::Room&)>& spoil) {
        testing::Room room = testing::cube(.5, .5, .5);
        spoil(room);
        return refusal(room.problem()).value_or("nothing");
    };
    constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
    EXPECT_NE(saysAfter([](auto& room) { room.areas[2] = 0; }).find("patch 2 has an area of 0"), std::string::npos);
    EXPECT_NE(saysAfter([](auto& room) { room.areas[2] = kNone; }).find("patch 2 has an area"), std::string::npos);
    EXPECT_NE(saysAfter([](auto& room) { room.emission[1].y = -1; }).find("patch 1 emits -1"), std::string::npos);
    EXPECT_NE(saysAfter([](auto& room) { room.emission[1].z = kNone; }).find("patch 1 emits"), std::string::npos);
    EXPECT_NE(saysAfter([](auto& room) { room.reflectance[5].x = 1.5; }).find("patch 5 has a reflectance of 1.5"),
              std::string::npos);
    EXPECT_NE(saysAfter([](auto& room) { room.exchange.set(4, 3, -0.1); }).find("patch 3 has a form factor"),
              std::string::npos);
    EXPECT_NE(saysAfter([](auto& room) { room.areas.pop_back(); }).find("6 patches, but 5 areas"), std::string::npos);
    EXPECT_EQ(saysAfter([](auto&) {}), "nothing");
    const testing::Room empty{ExchangeMatrix(0), {}, {}, {}};
    EXPECT_NE(refusal(empty.problem()).value_or("").find("no patches"), std::string::npos);
}

} // namespace
} // namespace shadowlab::radiosity
