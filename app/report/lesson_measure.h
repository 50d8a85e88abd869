// Is the artefact of a lesson really there, and really gone? The numbers of its two states, beside what they have to be.
// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <vector>

#include "app/course/lessons/lesson.h"

namespace shadowlab::report {

/// One expectation of a lesson, measured in both states.
struct MeasuredExpectation {
    std::array<double, 2> values{}; ///< before, after
    /// How many pixels, frames or numbers the values are about: where it is 0, they prove nothing.
    std::array<int, 2> compared{};
    std::array<bool, 2> holds{};
};

/// The values of one of the two states (0 before, 1 after), in the order of the lesson's expectations; of each, how many pixels, frames
/// or numbers it is about. Throws as measureLesson does. Needs a current GL context.
struct MeasuredValue {
    double value = 0;
    int compared = 0;
};
std::vector<MeasuredValue> measureState(const course::Lesson& lesson, std::size_t state);

/// Both states, in the order of the lesson's expectations. A value that could not be measured (a fact that no probe contains) is an Error
/// (badInput) naming what there is. Needs a current GL context.
std::vector<MeasuredExpectation> measureLesson(const course::Lesson& lesson);

/// Does all of it hold, and was there something to be compared?
bool holdsAsExpected(const std::vector<MeasuredExpectation>& measured);

} // namespace shadowlab::report
