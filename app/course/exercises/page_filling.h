// Which exercises share a printed page.
// SPDX-License-Identifier: MIT
#pragma once
#include <vector>

#include "app/course/exercises/exercise.h"

namespace shadowlab::course {

/// The height that an exercise takes on paper, its room for answers included, in millimetres. Lines are guessed from the number of letters.
double heightOnPaper(const Exercise& exercise);

/// The height that is filled of a page, and what the sheet's title takes of the first, in millimetres. A4 has 263 mm of height within its margins,
/// letter paper 255.
constexpr double kPageHeight = 255, kHeaderHeight = 27;

/// The exercises in an order in which few pages hold them all, none of them broken: first fit by falling height. Pages and what is on one
/// keep the order of the lectures; the page with most room left is the last. The same for all kinds of paper.
std::vector<Exercise> fillPages(std::vector<Exercise> exercises);

/// The widest squared paper, 1212 pixels, is nearly as wide as a line, with squares of seven millimetres to draw on.
constexpr double kMillimetresOfPixel = 152.0 / 1212;

} // namespace shadowlab::course
