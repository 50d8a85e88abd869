// The numbers that a gather ray chooses by, over all sequences.
// SPDX-License-Identifier: MIT
#include "techniques/radiosity/display/ray_numbers.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <vector>

#include "techniques/foundation/math/random_pair.h"

namespace shadowlab::radiosity {
namespace {

using Number = std::function<double(const RayNumbers&)>;

/// Of 8 x 8 x 8 cells of the unit cube, how many of the points of that ray, one for each of 64000 shifts, lie in the one with the fewest, over the mean.
double fewestInACell(const Number& x, const Number& y, const Number& z) {
    constexpr int kSide = 8, kShifts = 64000;
    std::vector<int> cells(kSide * kSide * kSide);
    for (std::uint64_t i = 0; i < kShifts; ++i) {
        const RayNumbers numbers(17, randomPair(i));
        const auto cell = [](double at) { return std::min(static_cast<std::size_t>(at * kSide), std::size_t{kSide - 1}); };
        EXPECT_GE(x(numbers), 0);
        EXPECT_LT(x(numbers), 1);
        ++cells[(cell(x(numbers)) * kSide + cell(y(numbers))) * kSide + cell(z(numbers))];
    }
    return *std::ranges::min_element(cells) / (static_cast<double>(kShifts) / static_cast<double>(cells.size()));
}

// In each cell there are 125 but for chance, which is 11; where one number is a function of two others most are empty.
TEST(RayNumbers, OverAllSequencesTheyFillTheCube) {
    const Number direction = [](const RayNumbers& n) { return n.direction().x; }, turn = [](const RayNumbers& n) { return n.direction().y; },
                 which = [](const RayNumbers& n) { return n.which(); }, where = [](const RayNumbers& n) { return n.where().x; },
                 across = [](const RayNumbers& n) { return n.where().y; }, onLight = [](const RayNumbers& n) { return n.onLight().x; },
                 first = [](const RayNumbers& n) { return n.onward(0).x; }, second = [](const RayNumbers& n) { return n.onward(1).x; },
                 last = [](const RayNumbers& n) { return n.onward(kMostReflections - 1).y; },
                 onwardWhich = [](const RayNumbers& n) { return n.onwardWhich(1); };
    EXPECT_GT(fewestInACell(which, where, across), 0.6);
    EXPECT_GT(fewestInACell(direction, turn, first), 0.6);
    EXPECT_GT(fewestInACell(direction, first, second), 0.6);
    EXPECT_GT(fewestInACell(first, second, last), 0.6);
    EXPECT_GT(fewestInACell(direction, turn, onLight), 0.6);
    EXPECT_GT(fewestInACell(second, last, onwardWhich), 0.6);
    EXPECT_LT(fewestInACell(direction, direction, turn), 0.1) << "the measure sees what goes together";
}

} // namespace
} // namespace shadowlab::radiosity
