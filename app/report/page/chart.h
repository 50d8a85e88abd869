// Cost against error: the points of a group in a chart with logarithmic axes.
// SPDX-License-Identifier: MIT
#pragma once
#include <string>
#include <vector>

#include "app/drawing/drawing.h"
#include "app/report/results.h"

namespace shadowlab::report {

struct Chart {
    drawing::Drawing drawing;
    struct Spot {
        std::size_t point; ///< of Group::points
        dvec2 place;       ///< of the middle of its marker, in pixels of the sheet
    };
    std::vector<Spot> spots; ///< in the order of the points; those that have no place are left out
    dvec2 plotCorner{0.0}, plotSize{0.0}; ///< of the axes with what is written at them, without title and legends
};

/// Printed 16 cm wide, the sheet's smallest letters are 8 points high: 22 of its 1200 pixels.
inline constexpr double kChartWidth = 1200, kChartType = 22;

/// Points without an error stand in a row of their own, since zero has no place on a logarithmic axis. Points that have not
/// been measured have no place, and neither have those without a defined error: some pixels are wrong, and there is no boundary to
/// relate them to. A line below says how many these are. `size`: of the pictures, for the title.
Chart chartOf(const Group& group, ivec2 size);

/// As SVG.
std::string costErrorChart(const Group& group, ivec2 size);

/// What the chart is, in words: "still-life, light key: cost and error".
std::string chartTitle(const Group& group);

} // namespace shadowlab::report
