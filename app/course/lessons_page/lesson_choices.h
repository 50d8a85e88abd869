// What the page of lessons asks of an artefact, and the answers to choose from.
// SPDX-License-Identifier: MIT
#pragma once
#include <string>
#include <vector>

#include "app/course/lessons/lesson.h"

namespace shadowlab::course {

struct LessonChoices {
    std::string question;
    std::vector<std::string> choices;
    std::size_t right = 0;   ///< index of the right one
    std::size_t picture = 0; ///< the state that is shown while it is asked
};

/// The lesson's own question, where it has one with choices. Else "What has gone wrong here?", after what a question without choices
/// tells, with the lesson's title among two or three titles of other lessons of `course`: of those of its own chapter first, then of
/// chapters about the same kind of technique ("Shadow map: ..."), and of other chapters only where there would be less than two. Lessons
/// that are alike are no wrong answers to each other. Which they are, and in which order they stand, follows from the names of the
/// lessons: it is always the same.
LessonChoices choicesOf(const Lesson& lesson, const std::vector<LessonText>& course);

} // namespace shadowlab::course
