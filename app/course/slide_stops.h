// A slide in the window: the states that its pictures show, one after another, or together where the window can.
// SPDX-License-Identifier: MIT
#pragma once
#include <string>
#include <vector>

#include "app/course/deck.h"
#include "app/lab/document.h"

namespace shadowlab::course {

struct SlideStop {
    lab::Document document;
    std::string label;  ///< of the picture, or of all of them; may be empty
    std::string writtenLabel; ///< the same with formulas between $
    std::string figure; ///< the drawing that the slide shows of the picked pixel; empty: it shows what the window does
};

/// In the order of the slide; none where it has words alone. Two or four pictures of one scene, through one camera and one
/// technique each, are one stop: side by side, or in a grid.
std::vector<SlideStop> stopsOf(const Slide& slide);

} // namespace shadowlab::course
