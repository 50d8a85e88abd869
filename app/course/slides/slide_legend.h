// The legend below a picture of a slide: dark on the slide's paper, so that it covers nothing of what is to be seen.
// SPDX-License-Identifier: MIT
#pragma once
#include "app/course/slides/slide_layout.h"
#include "app/picture/figure.h"

namespace shadowlab::course {

/// How high the panel's legend is in that width, in units of the layout; 0: it needs none.
double legendHeight(const picture::Panel& panel, double width, const Fonts& fonts);

/// Draws it with its upper left corner there.
void drawLegendBelow(drawing::Drawing& drawing, const picture::Panel& panel, dvec2 corner, double width, const Fonts& fonts);

/// The text of a legend as prose: what stands before its colon, or all of it, is a formula between two $ if it compares two things, as
/// in "d < z: in shadow". All other texts stay what they are. Stages name their colours in plain letters, which every legend can show.
std::string legendProse(const std::string& label);

} // namespace shadowlab::course
