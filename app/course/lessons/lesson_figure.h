// A lesson as a figure: one or both of its states, with the title above, the sentences below, and what to look at framed.
// SPDX-License-Identifier: MIT
#pragma once
#include <vector>

#include "app/course/lessons/lesson.h"
#include "app/picture/picture.h"
#include "techniques/foundation/image/text.h"

namespace shadowlab::course {

/// Which of the states, as indices of Lesson::states, from left to right.
using ShownStates = std::vector<std::size_t>;

/// "1 of 2: the artefact" and "2 of 2: the remedy".
std::string stateTitle(std::size_t state);

/// The sentence that belongs to a state: what happens, or what removes it.
const std::string& sentenceOf(const Lesson& lesson, std::size_t state);

/// "shadow-map.bias-mode=none" as a line below the sentence: what makes the state what it is.
std::string settingsLine(const ShownState& state);

/// Draws the states with their techniques. Throws Error (usage) for a size in which the pictures would have no room
/// beside their words. Needs a current GL context.
image::Image lessonFigure(const Lesson& lesson, const ShownStates& states, ivec2 size, const image::Font& font,
                          const image::Font& bold);

} // namespace shadowlab::course
