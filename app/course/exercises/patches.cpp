// Exercises about form factors and the radiosity equations.
// SPDX-License-Identifier: MIT
#include <cmath>
#include <numbers>

#include "app/course/exercises/kinds.h"

namespace shadowlab::course {

namespace {

/// The form factor between two equal squares, one right above the other, in closed form (J. Howell, A Catalog of Radiation Configuration
/// Factors, C-11). `ratio`: of their side to their distance.
double oppositeSquares(double ratio) {
    const double square = ratio * ratio, root = std::sqrt(1 + square);
    return 2 / (std::numbers::pi * square) *
           (std::log((1 + square) / std::sqrt(1 + 2 * square)) + 2 * ratio * root * std::atan(ratio / root) -
            2 * ratio * std::atan(ratio));
}

} // namespace

Exercise askForFormFactor(Chance& chance) {
    // Vectors between the patches with a length that is a whole number; the patches are level or upright.
    const dvec3 between = chance.oneOf(std::vector<dvec3>{{1, 2, 2},
                                                          {2, 1, 2},
                                                          {2, 2, 1},
                                                          {2, 3, 6},
                                                          {3, 2, 6},
                                                          {6, 3, 2},
                                                          {2, 6, 3},
                                                          {4, 4, 7},
                                                          {1, 8, 4},
                                                          {4, 8, 1},
                                                          {3, 6, 2}});
    const dvec3 first(chance.between(-3, 3), 0, chance.between(-3, 3)), second = first + between;
    const bool upright = chance.coin();
    const dvec3 normal1(0, 1, 0), normal2 = upright ? dvec3(-1, 0, 0) : dvec3(0, -1, 0);
    const double area1 = chance.oneOf(std::vector<double>{0.01, 0.02, 0.04}),
                 area2 = chance.oneOf(std::vector<double>{0.01, 0.03, 0.05, 0.06});
    const double distance = glm::length(between), cos1 = glm::dot(normal1, between) / distance,
                 cos2 = -glm::dot(normal2, between) / distance;
    const double there = cos1 * cos2 * area2 / (std::numbers::pi * distance * distance), back = there * area1 / area2;
    Exercise exercise;
    exercise.given = "Two small patches see each other. Patch 1 is at " + printed(first) + " with the normal " +
                     printed(normal1) + " and the area " + printed(area1) + " m², patch 2 at " + printed(second) +
                     " with the normal " + printed(normal2) + " and the area " + printed(area2) +
                     " m². Their distance is large for their size.";
    exercise.questions = {"Find the distance r and the cosines of the two angles.",
                          "What are the form factors $F_{12}$ and $F_{21}$? Give them in millionths."};
    exercise.answers = {"r = " + printed(distance) + " m, $\\cos\\theta_1$ = " + printed(cos1) +
                            ", $\\cos\\theta_2$ = " + printed(cos2),
                        "$F_{12}$ = " + printed(1e6 * there) + " millionths, $F_{21}$ = " + printed(1e6 * back) +
                            " millionths"};
    exercise.working = "$F_{12} = \\frac{\\cos\\theta_1 \\cos\\theta_2 A_2}{\\pi r^2}$, and $A_1 F_{12} = A_2 F_{21}$.";
    exercise.mistake = "The area is that of the patch which receives; each angle is to the patch's own normal.";
    addVector(exercise.data, "first", first);
    addVector(exercise.data, "second", second);
    exercise.data.insert(exercise.data.end(),
                         {{"upright", upright ? 1.0 : 0.0}, {"area1", area1}, {"area2", area2}});
    exercise.results = {{"r", distance}, {"cos1", cos1}, {"cos2", cos2}, {"F12", there}, {"F21", back}};
    return exercise;
}

Exercise askForRowSum(Chance& chance) {
    const int side = chance.between(1, 9);
    int height = 0;
    do
        height = chance.between(1, 9);
    while (height > 4 * side || side > 3 * height);
    const double s = side, h = height;
    // To three digits, as it is printed: all else follows from what the sheet says.
    const double toCeiling = std::round(oppositeSquares(s / h) * 1000) / 1000, toWall = (1 - toCeiling) / 4,
                 fromWall = toWall * s * s / (s * h);
    Exercise exercise;
    exercise.given = "A room without windows has a floor of " + std::to_string(side) + " m by " + std::to_string(side) +
                     " m and is " + std::to_string(height) +
                     " m high. Each of its six sides is a patch: floor (F), ceiling (C) and four walls (W). The form "
                     "factor from the floor to the ceiling is $F_{FC}$ = " +
                     printed(toCeiling) + ".";
    exercise.questions = {"What is the form factor $F_{FW}$ from the floor to one wall?",
                          "What is $F_{WF}$, from a wall to the floor?",
                          "Which share of the light that leaves a wall reaches the three other walls together?"};
    const double toWalls = 1 - 2 * fromWall;
    exercise.answers = {"$F_{FW}$ = " + printed(toWall), "$F_{WF}$ = " + printed(fromWall), printed(toWalls)};
    exercise.working = "A row adds up to 1, and the floor does not see itself: (1 - " + printed(toCeiling) +
                       ") / 4. $A_F F_{FW} = A_W F_{WF}$ with $A_F$ = " + printed(s * s) +
                       " m² and $A_W$ = " + printed(s * h) +
                       " m². A wall sends as much to the ceiling as to the floor; the rest goes to the other walls.";
    exercise.mistake = "$F_{FW}$ and $F_{WF}$ differ where the areas do.";
    exercise.data = {{"side", s}, {"height", h}, {"FFC", toCeiling}};
    exercise.results = {{"FFW", toWall}, {"FWF", fromWall}, {"toWalls", toWalls}};
    return exercise;
}

Exercise askForTwoPatches(Chance& chance) {
    const double area1 = chance.between(1, 4), area2 = chance.oneOf(std::vector<double>{1, 2, 4, 5}),
                 f12 = chance.between(1, 2) / 10.0;
    const double rho1 = chance.oneOf(std::vector<double>{0.2, 0.4, 0.5}),
                 rho2 = chance.oneOf(std::vector<double>{0.5, 0.6, 0.8}), emitted = chance.between(2, 20) * 5;
    const double f21 = f12 * area1 / area2;
    const double b1 = emitted / (1 - rho1 * rho2 * f12 * f21), b2 = rho2 * f21 * b1;
    Exercise exercise;
    exercise.given = "Two patches in an otherwise black room: $A_1$ = " + printed(area1) +
                     " m², $A_2$ = " + printed(area2) + " m², $F_{12}$ = " + printed(f12) +
                     ". Patch 1 emits $E_1$ = " + printed(emitted) + " W/m² and reflects $\\rho_1$ = " + printed(rho1) +
                     " of the light that it gets; patch 2 emits nothing and reflects $\\rho_2$ = " + printed(rho2) +
                     ".";
    exercise.questions = {"What is $F_{21}$?",
                          "Write down the radiosity equations and solve them: what are $B_1$ and $B_2$?",
                          "What is $B_2$ after one bounce, that is with $B_1 = E_1$?"};
    const double once = rho2 * f21 * emitted;
    exercise.answers = {"$F_{21}$ = " + printed(f21),
                        "$B_1$ = " + printed(b1) + " W/m², $B_2$ = " + printed(b2) + " W/m²", printed(once) + " W/m²"};
    exercise.working = "$A_1 F_{12} = A_2 F_{21}$. $B_1 = E_1 + \\rho_1 F_{12} B_2$ and $B_2 = \\rho_2 F_{21} B_1$, so "
                       "$B_1 = \\frac{E_1}{1 - \\rho_1 \\rho_2 F_{12} F_{21}}$.";
    exercise.mistake = "In the equation of patch 2 stands $F_{21}$: the share of what leaves patch 2 that reaches "
                       "patch 1 is also what patch 2 gathers from it.";
    exercise.data = {{"A1", area1}, {"A2", area2}, {"F12", f12}, {"E1", emitted}, {"rho1", rho1}, {"rho2", rho2}};
    exercise.results = {{"F21", f21}, {"B1", b1}, {"B2", b2}, {"once", once}};
    return exercise;
}

} // namespace shadowlab::course
