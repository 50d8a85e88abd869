// The pictures that stand on a slide, one by one. A state that shows techniques side by side is several of them, so that each has its
// name above it and its legend below it.
// SPDX-License-Identifier: MIT
#pragma once
#include <string>
#include <vector>

#include "app/course/deck.h"

namespace shadowlab::course {

/// The parts in the order of the slide: `label` is what stands above a part, with formulas between $; callouts are in shares of it.
struct SlidePart {
    SlidePicture picture;
    std::string label;
};
std::vector<SlidePart> partsOf(const Slide& slide);

/// Two bands of one picture, each with the name of its technique above it.
bool hasBands(const SlidePart& part);
/// Has it colours that a legend may explain? Finished pictures and drawings have none.
bool mayHaveLegend(const SlidePart& part);

} // namespace shadowlab::course
