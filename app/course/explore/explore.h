// What a deck says of an explorable slide: in the page of `slides --explore` it is no picture but a small lab, in which a lamp is
// dragged, techniques are compared, settings changed, passes followed, and pixels asked (docs/explore.md).
// SPDX-License-Identifier: MIT
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "app/course/lessons/lesson.h"
#include "techniques/foundation/scene/json/json_object.h"

namespace shadowlab::course {

/// A parameter of a technique, and which of its values the page has.
struct ExploredSetting {
    std::string technique, param;
    std::vector<std::string> values; ///< as --set takes them
};

/// Something to be found in the page, which checks the answer by the numbers of the state that is shown.
struct ExploreTask {
    std::string question; ///< with formulas between $
    std::string told;     ///< when it is solved
    std::string number;   ///< of a state: "coreErrors", "falseLit" ... (explored_numbers.h)
    int pane = 0;         ///< whose, counted from 0
    Bound bound;
};

/// As the deck has it. With --explore-budget a page may have less of it.
struct Explore {
    int lampPositions = 24;    ///< 1: the lights stay where they are
    double lampDegrees = 360;  ///< of the orbit that the positions are spread over (film/orbit.h)
    bool steps = true, errors = true;
    int askPoints = 24;        ///< 0: no pixel is asked
    std::vector<std::string> stages; ///< beside those that the slide shows
    std::vector<ExploredSetting> settings;
    std::optional<ExploreTask> task;
};

/// What "explore" of a slide says; `top` is the slide. None where it is absent or false. Throws Error (badInput) with FILE:LINE:COLUMN.
std::optional<Explore> readExplore(const scene::JsonObject& top);

} // namespace shadowlab::course
