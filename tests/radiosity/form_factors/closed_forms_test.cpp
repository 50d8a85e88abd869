// Rooms whose radiosity is known in closed form, by every solver.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <array>

#include "techniques/radiosity/equations/bounces.h"
#include "techniques/radiosity/solvers/solvers.h"
#include "tests/radiosity/rooms.h"

namespace shadowlab::radiosity {
namespace {

/// Solved as far as the tests below look, by the bound. No solver needs more than half of these steps for it.
std::vector<dvec3> solved(SolverKind kind, const Problem& problem, double tolerance) {
    const auto solver = makeSolver(kind, problem);
    EXPECT_TRUE(solve(*solver, tolerance, 400'000)) << nameOf(kind) << " after " << solver->steps();
    return solver->radiosity();
}

/// Five patches inside a sphere, all different.
testing::Room fivePatches() {
    const std::array<double, 5> emission = {1, 0, 0.5, 0, 2}, reflectance = {0.9, 0.5, 0.2, 0.7, 0.3};
    std::vector<dvec3> emissions, reflectances;
    for (std::size_t i = 0; i < 5; ++i) {
        emissions.emplace_back(emission[i]);
        reflectances.emplace_back(reflectance[i]);
    }
    return testing::sphereInside({0.1, 0.2, 0.3, 0.25, 0.15}, emissions, reflectances);
}

TEST(RadiosityClosedForms, InsideASphereAllPatchesGetTheSame) {
    // H = mean E / (1 - mean rho), means by area: .55 / .53. The numbers are given to 17 digits.
    constexpr double kIrradiance = 1.0377358490566038;
    const std::array<double, 5> expected = {1.9339622641509435, .5188679245283019, .7075471698113207, .7264150943396226,
                                            2.311320754716981};
    const testing::Room room = fivePatches();
    int compared = 0;
    for (const SolverKind kind : kSolverKinds) {
        const std::vector<dvec3> radiosity = solved(kind, room.problem(), 1e-12);
        const std::vector<dvec3> reaching = irradiance(room.problem(), radiosity);
        for (std::size_t i = 0; i < 5; ++i)
            for (int c = 0; c < 3; ++c) {
                EXPECT_NEAR(radiosity[i][c], expected[i], 1e-11) << nameOf(kind); // by the bound; asked for is 1e-9
                EXPECT_NEAR(reaching[i][c], kIrradiance, 1e-11) << nameOf(kind);
                ++compared;
            }
    }
    EXPECT_EQ(compared, 6 * 5 * 3);
}

// The classical slip, F_ji for F_ij: harmless while all areas are equal, and so for long unnoticed.
TEST(RadiosityClosedForms, FormFactorsTheWrongWayRoundAreFoundOut) {
    const testing::Room room = fivePatches();
    std::vector<double> radiosity(5, 0.0);
    for (int sweep = 0; sweep < 200; ++sweep) {
        std::vector<double> next(5);
        for (std::size_t i = 0; i < 5; ++i) {
            next[i] = room.emission[i].x;
            for (std::size_t j = 0; j < 5; ++j)
                next[i] += room.reflectance[i].x * room.exchange(j, i) / room.areas[j] * radiosity[j];
        }
        radiosity = next;
    }
    EXPECT_GT(std::abs(radiosity[0] - 1.9339622641509435), 0.1);
}

TEST(RadiosityClosedForms, WhereAllIsEqualLightAddsUpAsAGeometricSeries) {
    int compared = 0;
    for (const auto& [reflectance, expected] :
         std::array<std::pair<double, double>, 4>{{{.5, 2}, {.9, 10}, {.99, 100}, {.999, 1000}}}) {
        testing::Room room = testing::cube(reflectance, reflectance, reflectance);
        room.emission.assign(6, dvec3(1));
        const testing::Room sphere =
            testing::sphereInside({1, 2, 3}, std::vector(3, dvec3(1)), std::vector(3, dvec3(reflectance)));
        for (const testing::Room* enclosure : std::array<const testing::Room*, 2>{&room, &sphere})
            for (const SolverKind kind : kSolverKinds)
                for (const dvec3& value : solved(kind, enclosure->problem(), 1e-10)) {
                    // By the bound, 1e-10 of B; and 1e-16 / (1 - rho) for the form factors, which are rounded.
                    EXPECT_NEAR(value.x, expected, 2e-10 * expected) << nameOf(kind);
                    ++compared;
                }
    }
    EXPECT_EQ(compared, 4 * 6 * (6 + 3));
}

TEST(RadiosityClosedForms, CubeWithALightFloor) {
    // Floor, wall, ceiling, given to 12 digits. Three reflectances at once, as three colours.
    const std::array<std::array<double, 3>, 3> expected = {{{1.09090909811, .181836268946, .181745826108},
                                                            {2.37288137483, 1.52545201851, 1.52531055112},
                                                            {17.3622704726, 16.5275760999, 16.5274251277}}};
    testing::Room room = testing::cube(0, 0, 0);
    room.reflectance.assign(6, dvec3(.5, .9, .99));
    int compared = 0;
    for (const SolverKind kind : kSolverKinds) {
        const std::vector<dvec3> radiosity = solved(kind, room.problem(), 1e-12);
        for (int c = 0; c < 3; ++c)
            for (std::size_t i = 0; i < 6; ++i) {
                const double right = expected[c][i == 0 ? 0 : i == 1 ? 2 : 1];
                EXPECT_NEAR(radiosity[i][c], right, 1e-10 * right) << nameOf(kind) << " patch " << i;
                ++compared;
            }
    }
    EXPECT_EQ(compared, 6 * 3 * 6);
}

TEST(RadiosityClosedForms, CubeOfThreeReflectances) {
    const testing::Room room = testing::cube(.2, .5, .8);
    int compared = 0;
    for (const SolverKind kind : kSolverKinds) {
        const std::vector<dvec3> radiosity = solved(kind, room.problem(), 1e-12);
        EXPECT_NEAR(radiosity[0].x, 1.04193385026, 1e-10) << nameOf(kind); // given to 12 digits
        EXPECT_NEAR(radiosity[1].x, .28822347823, 1e-10) << nameOf(kind);
        for (std::size_t wall = 2; wall < 6; ++wall) {
            EXPECT_NEAR(radiosity[wall].x, .190052182349, 1e-10) << nameOf(kind);
            // Four walls alike: alike within the bound, and with solvers that treat all patches at once far closer.
            EXPECT_NEAR(radiosity[wall].x, radiosity[2].x, 2e-12) << nameOf(kind);
        }
        ++compared;
    }
    EXPECT_EQ(compared, 6);
}

// What the tables stand on.
TEST(RadiosityClosedForms, FormFactorsOfTheCube) {
    EXPECT_NEAR(testing::oppositeInCube(), 0.199824895698, 5e-13); // given to 12 digits
    EXPECT_NEAR(testing::adjacentInCube(), 0.200043776075, 5e-13);
    EXPECT_NEAR(testing::oppositeInCube() + 4 * testing::adjacentInCube(), 1, 3e-16);
}

} // namespace
} // namespace shadowlab::radiosity
