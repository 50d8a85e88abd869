// A chart's legend as text: on a phone a chart is as wide as the screen, and words beside it would be too small to read.
// SPDX-License-Identifier: MIT
#pragma once
#include <string>

#include "app/report/page/technique_mark.h"
#include "app/report/results.h"

namespace shadowlab::report {

/// A technique's marker as a small picture in a line of text. `isOpen`: white inside.
std::string markOf(const TechniqueMark& mark, bool isOpen);

/// All that drawLegend() and drawFrontKey() write, in full length.
std::string phoneLegend(const Group& group);

} // namespace shadowlab::report
