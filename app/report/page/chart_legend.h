// What stands around a chart: what its marks mean, and which points its front consists of.
// SPDX-License-Identifier: MIT
#pragma once
#include "app/drawing/drawing.h"
#include "app/report/results.h"
#include "techniques/foundation/image/text.h"

namespace shadowlab::report {

/// The points of the Pareto front that a chart can show, the cheapest first. Their numbers in chart and key count from 1.
std::vector<std::size_t> frontOf(const Group& group);

/// Can the chart show it? (See chartOf.)
bool hasPlace(const Point& point);
/// Is it in the row of those without an error?
bool isInZeroRow(const Point& point);

/// The titles that a technique's sweeps have in the chart, in the order of their points.
std::vector<std::string> sweepsOf(const Group& group, const std::string& technique);
/// "1.2 ms, error 0.034 px"
std::string frontValues(const Group& group, const Point& point);

/// Writes techniques and lines in a column, `width` pixels wide, from `corner` down. Returns where it ends.
double drawLegend(drawing::Drawing& drawing, const Group& group, const image::Font& font, dvec2 corner, double width);

/// Writes a line for each point of the front. `place`: the foot of its heading. Returns the height where it ends.
double drawFrontKey(drawing::Drawing& drawing, const Group& group, const image::Font& font, dvec2 place, double width);

/// As much of the text as is not wider than `width`, with an ellipsis where something is left out.
std::string fitted(const image::Font& font, const std::string& text, double em, double width);

} // namespace shadowlab::report
