// "Where it asks": the texels of the map around a point, the places at which a filter compares, and those at which a search
// looks for blockers.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include "app/figures/panels.h"
#include "techniques/foundation/base/look.h"
#include "techniques/probed/map_probe.h"

namespace shadowlab::figures {

namespace {

constexpr double kMostGrid = 48; ///< texels across: closer lines would be grey

} // namespace

bool hasTaps(const MapProbe& map) { return map.taps.size() > 1 || map.search; }

void drawTaps(drawing::Drawing& drawing, const drawing::Box& area, const MapProbe& map) {
    drawing.text(area.corner + dvec2(0, kText), "Where it asks", {.size = kText, .isBold = true});
    const double side = std::min(area.size.x, area.size.y - kText - 14);
    const drawing::Box field{area.corner + dvec2(0, kText + 14), dvec2(side)};
    const dvec2 middle = dvec2(map.str) * static_cast<double>(map.resolution);
    double reach = 1.6; // texels: a neighbour on each side
    const auto include = [&](const std::vector<MapProbe::Tap>& taps) {
        for (const MapProbe::Tap& tap : taps) {
            const dvec2 away = glm::abs(tap.placeTexels - middle);
            reach = std::max(reach, 1.1 * std::max(away.x, away.y));
        }
    };
    include(map.taps);
    if (map.search) include(map.search->looks);
    const double scale = 0.5 * side / reach;
    const auto at = [&](const dvec2& texels) {
        const dvec2 away = texels - middle;
        return field.corner + 0.5 * field.size + scale * dvec2(away.x, -away.y);
    };
    drawing.beginClip(field.corner, field.size);
    if (2 * reach <= kMostGrid)
        for (int axis = 0; axis < 2; ++axis)
            for (double line = std::ceil(middle[axis] - reach); line <= middle[axis] + reach; ++line) {
                dvec2 from = middle - reach, to = middle + reach;
                from[axis] = to[axis] = line;
                drawing.line(at(from), at(to), {"#d0d0d0", 1.5, false});
            }
    const auto colorOf = [](const MapProbe::Tap& tap) {
        return drawing::colorText(tap.isLit ? look::kEqualDepth : look::kOccluded);
    };
    if (map.search)
        for (const MapProbe::Tap& look : map.search->looks)
            drawing.circle(at(look.placeTexels), 5, "none", {colorOf(look), 2, false}, "look");
    for (const MapProbe::Tap& tap : map.taps)
        drawing.circle(at(tap.placeTexels), 5, colorOf(tap), {"#ffffff", 1, false}, "tap");
    for (const dvec2& arm : {dvec2(10, 0), dvec2(0, 10)})
        drawing.line(at(middle) - arm, at(middle) + arm, {"#1a1a1a", 2.5, false});
    drawing.endClip();
    drawing.rectangle(field.corner, field.size, "none", {"#bfbfbf", 2, false});
}

} // namespace shadowlab::figures
