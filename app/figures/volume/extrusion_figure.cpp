// "Extrude a point away from light source": P_L, P and P' of a vertex of the outline, as the technique extrudes it.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <limits>

#include "app/drawing/prose.h"
#include "app/figures/figure_drawers.h"
#include "app/figures/inks.h"
#include "app/figures/panels.h"
#include "app/figures/volume/volume_sketch.h"
#include "techniques/foundation/base/error.h"
#include "techniques/foundation/base/look.h"
#include "techniques/probed/volume_probe.h"

namespace shadowlab::figures {

namespace {

constexpr double kFormulaEm = 40, kExtrusionRow = 36, kExtrusionText = 28;
constexpr double kExtrusionLines = 110 + 2 * kExtrusionRow; ///< pixels of formula and numbers under the drawing

/// The vertex of the outline whose way from P to P' passes nearest to the picked point.
std::uint32_t chosenVertex(const CasterSolid& solid, const dvec3& pointWorld) {
    std::uint32_t best = 0;
    double least = std::numeric_limits<double>::infinity();
    for (const VolumeProbe::Caster::SilhouetteEdge& edge : solid.caster->outline)
        for (const std::uint32_t vertex : {edge.a, edge.b}) {
            const dvec3& from = solid.verticesWorld[vertex];
            const dvec4& end = solid.caster->extrudedWorld[vertex];
            const dvec3 way = end.w == 0 ? dvec3(end) : dvec3(end) - from;
            const double share = std::max(glm::dot(pointWorld - from, way) / glm::dot(way, way), 0.0);
            const double away = glm::length(from + (end.w == 0 ? share : std::min(share, 1.0)) * way - pointWorld);
            if (away >= least) continue;
            least = away;
            best = vertex;
        }
    return best;
}

std::string coordinates(const dvec3& place) {
    return "(" + fourDigits(place.x) + ", " + fourDigits(place.y) + ", " + fourDigits(place.z) + ")";
}

} // namespace

Diagram drawExtrusionFigure(const FigureSource& source) {
    const CasterSolid solid = casterSolid(source, false);
    if (solid.caster->outline.empty())
        throw Error(ExitStatus::badInput,
                    solid.object->name + " has no outline for this light; choose a pixel of another object");
    drawing::Drawing drawing(source.size);
    const drawing::Box area{dvec2(kSectionBorder), source.size - 2 * kSectionBorder},
        field{area.corner, area.size - dvec2(0, kExtrusionLines)};
    const VolumeSketch sketch(source, solid, field, true);
    const SpaceView& view = sketch.view();
    drawing::Labels labels(source.fonts(), field);
    sketch.drawReceivers(drawing);
    sketch.drawVolume(drawing, labels, 0.5, 0.16);

    const std::uint32_t vertex = chosenVertex(solid, source.probe.geometry[0].toWorld);
    const dvec3& p = solid.verticesWorld[vertex];
    const dvec4& end = solid.caster->extrudedWorld[vertex];
    const bool isEndless = end.w == 0,
               isShorter = isEndless || glm::length(sketch.drawnEnd(vertex) - dvec3(end)) > 1e-9;
    const dvec2 at = view(p), to = view(sketch.drawnEnd(vertex));
    const dvec2 light = sketch.lightIsNear()
                            ? view(sketch.drawnLight())
                            : view(p + glm::length(sketch.drawnLight() - p) * glm::normalize(solid.toLight(p)));
    const drawing::Stroke ray{ink::kLight, 4, false}, way{drawing::colorText(look::kVolumeSide), 6, false};
    drawing.arrow(light, at, ray, 0.5);
    if (!sketch.lightIsNear()) drawing.breakMark(glm::mix(light, at, 0.2), at - light, ray);
    drawing.arrow(at, to, way);
    if (isShorter) drawing.breakMark(glm::mix(at, to, 0.8), to - at, way);
    labels.avoid(light, at);
    labels.avoid(at, to);
    for (const dvec2& place : {at, to}) {
        if (place == to && isEndless) continue;
        drawing.circle(place, 9, "#1a1a1a", {"#ffffff", 2, false}, place == at ? "vertex" : "extruded");
        labels.avoid({place - 10.0, dvec2(20)});
    }
    sketch.drawLight(drawing, labels, false);
    const drawing::TextStyle letter{.size = drawing::kLetter, .isBold = true};
    labels.place(drawing, at, "P", letter, 12);
    labels.place(drawing, to, isEndless ? "P\u2032 at infinity" : "P\u2032", letter, 12);
    drawing::TextStyle measure = letter;
    measure.color = drawing::colorText(look::kVolumeSide);
    const double d = isEndless ? 0 : glm::length(dvec3(end) - p);
    if (!isEndless) labels.place(drawing, glm::mix(at, to, 0.5), "$d = $" + fourDigits(d) + " m", measure, 16);

    const bool isSun = solid.lightWorld.w == 0;
    const char* tex =
        isEndless && isSun ? "\\mathbf{P}' = (-\\mathbf{L}, 0)"
        : isEndless        ? "\\mathbf{P}' = (\\mathbf{P} - \\mathbf{P}_L, 0)"
        : isSun            ? "\\mathbf{P}' = \\mathbf{P} - d\\,\\mathbf{L}"
                : "\\mathbf{P}' = \\mathbf{P} + d \\frac{\\mathbf{P} - \\mathbf{P}_L}{|\\mathbf{P} - \\mathbf{P}_L|}";
    const drawing::FormulaFonts fonts = source.fonts();
    const drawing::Formula formula(tex);
    const drawing::Extent extent = formula.measure(kFormulaEm, fonts);
    dvec2 foot = area.corner + dvec2(0, field.size.y + 14);
    formula.draw(drawing, foot + dvec2(0, extent.above), kFormulaEm, "#1a1a1a", fonts);
    const std::string how = solid.caster->distance ? "d is the same for all vertices"
                            : isEndless            ? "homogeneous: w' = 0, a point at infinity"
                                                   : "d of each vertex: up to a plane beyond all that is shadowed";
    const std::vector<std::string> lines =
        source.font.wrap(how, kText, static_cast<int>(area.size.x - extent.width - 50));
    for (std::size_t i = 0; i < lines.size() && i < 2; ++i)
        drawing.text(foot + dvec2(extent.width + 50, extent.above + kExtrusionRow * static_cast<double>(i)), lines[i],
                     {.size = kText, .color = "#4d4d4d"});
    foot.y += 110 + kText - 10;
    const dvec4& l = solid.lightWorld;
    const drawing::TextStyle numbers{.size = kExtrusionText};
    drawing::drawProse(drawing, foot,
                       std::string(isSun ? "$\\mathbf{L} = $" : "$\\mathbf{P}_L = $") + coordinates(dvec3(l)) + ",  $\\mathbf{P} = $" +
                           coordinates(p),
                       numbers, fonts);
    std::string extruded = coordinates(dvec3(end));
    if (isEndless) extruded.insert(extruded.size() - 1, ", 0");
    drawing::drawProse(drawing, foot + dvec2(0, kExtrusionRow),
                       "$\\mathbf{P}' = $" + extruded +
                           (isEndless ? "" : ",  $d = |\\mathbf{P}' - \\mathbf{P}| = $" + fourDigits(d) + " m"),
                       numbers, fonts);
    return {std::move(drawing),
            "A vertex P of the outline of " + solid.object->name + ", extruded away from the light source to P'"};
}

} // namespace shadowlab::figures
