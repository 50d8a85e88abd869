// "Orientation of a polygon surface with respect to the light source": the polygon that the pixel shows, and one of the same object
// that is turned to the other side.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <limits>

#include "app/drawing/prose.h"
#include "app/figures/figure_drawers.h"
#include "app/figures/panels.h"
#include "app/figures/volume/facing_panel.h"
#include "techniques/foundation/base/error.h"

namespace shadowlab::figures {

namespace {

constexpr double kPolygonGap = 24, kPolygonLines = 84; ///< pixels; kPolygonLines: of the text under each drawing
constexpr double kWidePolygon = 520;                    ///< from which on there is room for larger type

/// Of the polygons on the other side the one that is turned away as much as this one is turned toward the light; of equal
/// ones the nearest.
std::size_t counterpart(const CasterSolid& solid, std::size_t polygon) {
    const auto cosine = [&](std::size_t t) { return solid.cosine(t) / glm::length(solid.toLight(solid.centre(t))); };
    const double wanted = -cosine(polygon);
    std::size_t best = polygon;
    std::pair<double, double> least{std::numeric_limits<double>::infinity(), 0};
    for (std::size_t t = 0; t < solid.triangles(); ++t) {
        if (solid.facesLight(t) == solid.facesLight(polygon)) continue;
        constexpr double kAlike = 0.02; // of a cosine; a smaller difference cannot be seen
        const std::pair unlike{std::round(std::abs(cosine(t) - wanted) / kAlike),
                               glm::length(solid.centre(t) - solid.centre(polygon))};
        if (unlike >= least) continue;
        least = unlike;
        best = t;
    }
    return best;
}

} // namespace

Diagram drawPolygonFigure(const FigureSource& source) {
    const CasterSolid solid = casterSolid(source, false);
    const std::size_t picked = nearestTriangle(solid, source.probe.geometry[0].toWorld),
                      other = counterpart(solid, picked);
    drawing::Drawing drawing(source.size);
    const std::vector<std::size_t> polygons = other == picked ? std::vector{picked} : std::vector{picked, other};
    const double width = (source.size.x - 2 * kSectionBorder - kPolygonGap * static_cast<double>(polygons.size() - 1)) /
                         static_cast<double>(polygons.size());
    std::vector<drawing::Box> cells;
    std::vector<FacingPanel> panels;
    double scale = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < polygons.size(); ++i) {
        cells.push_back({{kSectionBorder + static_cast<double>(i) * (width + kPolygonGap), kSectionBorder},
                         {width, source.size.y - 2 * kSectionBorder}});
        panels.emplace_back(solid, polygons[i], drawing::Box{cells[i].corner, cells[i].size - dvec2(0, kPolygonLines)});
        scale = std::min(scale, panels[i].pixelsPerMetre());
    }
    for (std::size_t i = 0; i < polygons.size(); ++i) {
        const drawing::Box& cell = cells[i];
        FacingPanel& panel = panels[i];
        panel.limitScale(scale);
        panel.draw(drawing, source.font);
        const double product = panel.products().front();
        const dvec2 foot = cell.corner + dvec2(0.5 * width, cell.size.y - kPolygonLines + 38);
        const double em = width >= kWidePolygon ? kHeading : kText;
        drawing::drawProse(drawing, foot, productText(product, 0, solid.unit()), {.size = em, .anchor = drawing::Anchor::middle},
                           source.fonts());
        drawing.text(foot + dvec2(0, 36),
                     product > 0 ? "toward the light: front facing" : "away from the light: back facing",
                     {.size = em, .anchor = drawing::Anchor::middle, .isBold = true});
    }
    return {std::move(drawing),
            "A polygon of " + solid.object->name +
                " with its normal N and the direction L to the light source, and one that is turned "
                "to the other side"};
}

} // namespace shadowlab::figures
