// Exercises as pages for a browser, which print as a worksheet.
// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "app/course/exercises/exercise.h"

namespace shadowlab::course {

enum class Paper { a4, letter };

/// What is handed out: questions, figures, and room for answers. Nothing of the answers. One page of HTML that asks for no other file.
std::string sheetPage(const std::vector<Exercise>& exercises, std::uint64_t seed, Paper paper);

/// The answers to it, by the same numbers.
std::string keyPage(const std::vector<Exercise>& exercises, std::uint64_t seed, Paper paper);

} // namespace shadowlab::course
