// What is shown while something moves: one state for each frame.
// SPDX-License-Identifier: MIT
#pragma once
#include <vector>

#include "app/course/lessons/lesson.h"

namespace shadowlab::course {

/// As many as the motion has frames; the first is the state itself. What does not move keeps its revisions from frame to frame.
std::vector<ShownState> statesInMotion(const ShownState& atRest, const film::Motion& motion);

} // namespace shadowlab::course
