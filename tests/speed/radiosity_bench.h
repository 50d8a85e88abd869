// What the parts of radiosity_bench share: the room that is solved (cornell_room.h), and how it is timed.
// SPDX-License-Identifier: MIT
#pragma once
#include <algorithm>
#include <chrono>
#include <filesystem>
#include <vector>

#include "tests/speed/cornell_room.h"
#include "tests/speed/median.h"

namespace shadowlab::radiosity {

double clockMs(const auto& work) {
    const auto start = std::chrono::steady_clock::now();
    work();
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

/// The parts of the bench. Each prints a table, and draws its charts into a folder unless that is empty.
void benchGrowth(int halvings, const std::filesystem::path& plots);
void benchSolvers(std::size_t count, const std::filesystem::path& plots);
void benchHemicube(std::size_t count, const std::filesystem::path& plots);

} // namespace shadowlab::radiosity
