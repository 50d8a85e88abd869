// "Determine object outlines": the outline edge nearest to the pixel between the two polygons that share it, and an edge of the
// same object that is no outline.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <limits>
#include <optional>

#include "app/drawing/prose.h"
#include "app/figures/figure_drawers.h"
#include "app/figures/panels.h"
#include "app/figures/volume/facing_panel.h"
#include "techniques/foundation/base/error.h"

namespace shadowlab::figures {

namespace {

constexpr double kEdgeGap = 24, kEdgeRow = 36, kEdgeText = 28;
constexpr double kWideEdge = 520; ///< pixels of a drawing from which on there is room for such type
constexpr double kEdgeLines = 4 * kEdgeRow + 14; ///< pixels of the text under each drawing
constexpr double kBent = 0.995; ///< cosine between two polygons: at less than six degrees the edge cannot be seen

struct SharedEdge {
    std::array<std::uint32_t, 2> ends{};
    std::array<std::size_t, 2> polygons{};
};

double away(const CasterSolid& solid, const scene::Edge& edge, const dvec3& placeWorld) {
    const dvec3 a = solid.verticesWorld[edge.a], way = solid.verticesWorld[edge.b] - a;
    const double share = glm::clamp(glm::dot(placeWorld - a, way) / glm::dot(way, way), 0.0, 1.0);
    return glm::length(a + share * way - placeWorld);
}

/// The nearest edge between two polygons for which that holds.
template <typename Holds>
std::optional<SharedEdge> nearestEdge(const CasterSolid& solid, const dvec3& placeWorld, const Holds& holds) {
    std::optional<SharedEdge> best;
    double least = std::numeric_limits<double>::infinity();
    for (const scene::Edge& edge : solid.topology.edges) {
        if (edge.useCount != 2) continue;
        SharedEdge one{{edge.a, edge.b},
                       {solid.topology.uses[edge.firstUse].triangle, solid.topology.uses[edge.firstUse + 1].triangle}};
        if (solid.facesLight(one.polygons[1]) && !solid.facesLight(one.polygons[0]))
            std::swap(one.polygons[0], one.polygons[1]);
        if (!holds(one)) continue;
        const double distance = away(solid, edge, placeWorld);
        if (distance >= least) continue;
        least = distance;
        best = one;
    }
    return best;
}

bool isOutline(const CasterSolid& solid, const SharedEdge& edge) {
    return solid.facesLight(edge.polygons[0]) != solid.facesLight(edge.polygons[1]);
}

/// Beside it an edge that is none; if there is one, between polygons that are turned differently.
std::optional<SharedEdge> otherEdge(const CasterSolid& solid, const SharedEdge& outline) {
    const dvec3 middle = 0.5 * (solid.verticesWorld[outline.ends[0]] + solid.verticesWorld[outline.ends[1]]);
    const auto bent = nearestEdge(solid, middle, [&](const SharedEdge& edge) {
        return !isOutline(solid, edge) && solid.facesLight(edge.polygons[0]) &&
               glm::dot(solid.normal(edge.polygons[0]), solid.normal(edge.polygons[1])) < kBent;
    });
    return bent ? bent : nearestEdge(solid, middle, [&](const SharedEdge& edge) { return !isOutline(solid, edge); });
}

FacingPanel panelOf(const drawing::Box& cell, const CasterSolid& solid, const SharedEdge& edge) {
    return {solid, edge.polygons, edge.ends, isOutline(solid, edge), {cell.corner, cell.size - dvec2(0, kEdgeLines)}};
}

void drawEdge(drawing::Drawing& drawing, const drawing::Box& cell, const CasterSolid& solid, const SharedEdge& edge,
              const FacingPanel& panel, const drawing::FormulaFonts& fonts) {
    const bool outline = isOutline(solid, edge);
    panel.draw(drawing, fonts.upright);
    dvec2 foot = cell.corner + dvec2(0.5 * cell.size.x, cell.size.y - kEdgeLines);
    const std::vector<double> products = panel.products();
    for (std::size_t i = 0; i < 2; ++i) {
        foot.y += kEdgeRow;
        drawing::drawProse(drawing, foot,
                           productText(products[i], static_cast<int>(i) + 1, solid.unit()) + (products[i] > 0 ? ": toward" : ": away"),
                           {.size = cell.size.x >= kWideEdge ? kEdgeText : kText, .anchor = drawing::Anchor::middle}, fonts);
    }
    const std::string sides = outline                              ? "One toward, one away:"
                              : solid.facesLight(edge.polygons[0]) ? "Both toward the light:"
                                                                   : "Both away from the light:";
    for (const std::string& line :
         {sides, std::string(outline ? "this edge is an outline" : "this edge is no outline")}) {
        foot.y += kEdgeRow + 2;
        drawing.text(foot, line, {.size = kHeading, .anchor = drawing::Anchor::middle, .isBold = true});
    }
}

} // namespace

Diagram drawEdgeFigure(const FigureSource& source) {
    const CasterSolid solid = casterSolid(source, false);
    const auto outline = nearestEdge(solid, source.probe.geometry[0].toWorld,
                                     [&](const SharedEdge& edge) { return isOutline(solid, edge); });
    if (!outline)
        throw Error(ExitStatus::badInput, "no edge of " + solid.object->name +
                                              " has one polygon that faces toward the light and one that faces away; "
                                              "choose a pixel of another object");
    const auto other = otherEdge(solid, *outline);
    drawing::Drawing drawing(source.size);
    const double columns = other ? 2 : 1,
                 width = (source.size.x - 2 * kSectionBorder - (columns - 1) * kEdgeGap) / columns;
    const dvec2 size(width, source.size.y - 2 * kSectionBorder);
    const drawing::Box left{dvec2(kSectionBorder), size}, right{left.corner + dvec2(width + kEdgeGap, 0), size};
    FacingPanel panel = panelOf(left, solid, *outline);
    if (!other) {
        drawEdge(drawing, left, solid, *outline, panel, source.fonts());
    } else {
        FacingPanel beside = panelOf(right, solid, *other);
        const double scale = std::min(panel.pixelsPerMetre(), beside.pixelsPerMetre());
        panel.limitScale(scale);
        beside.limitScale(scale);
        drawEdge(drawing, left, solid, *outline, panel, source.fonts());
        drawEdge(drawing, right, solid, *other, beside, source.fonts());
    }
    return {std::move(drawing),
            "An outline edge of " + solid.object->name +
                " between a polygon that faces toward the light and one that faces away, and an edge "
                "that is no outline"};
}

} // namespace shadowlab::figures
