// "Shadow volume": an enclosed region of space that is formed by extruding an object's outline from the light source; and where it
// cuts other objects.
// SPDX-License-Identifier: MIT
#include "app/figures/figure_drawers.h"
#include "app/figures/panels.h"
#include "app/figures/section_sheet.h"
#include "app/figures/volume/volume_sketch.h"
#include "techniques/foundation/base/look.h"

namespace shadowlab::figures {

namespace {

constexpr double kLegend = 112; ///< pixels; three rows of a legend on half a slide

} // namespace

Diagram drawVolumeFigure(const FigureSource& source) {
    const CasterSolid solid = casterSolid(source, true);
    drawing::Drawing drawing(source.size);
    const drawing::Box area{dvec2(kSectionBorder), source.size - 2 * kSectionBorder},
        field{area.corner, area.size - dvec2(0, kLegend)};
    const VolumeSketch sketch(source, solid, field);
    drawing::Labels labels(source.font, field);
    sketch.drawReceivers(drawing);
    sketch.drawVolume(drawing, labels, 0, 0.4);
    sketch.drawLight(drawing, labels, true);
    sketch.nameParts(drawing, labels);
    using enum LegendEntry::Kind;
    std::vector<LegendEntry> legend{{filled, drawing::colorText(look::kTopCap), "top cap: faces toward the light, unchanged"},
                                    {filled, drawing::colorText(look::kVolumeSide), "sides: outline edges, extruded"}};
    legend.push_back({filled, drawing::colorText(look::kBottomCap),
                      sketch.isCutOff()             ? "bottom cap: beyond this drawing"
                      : sketch.curveWorld().empty() ? "bottom cap: extruded"
                                                    : "bottom cap: extruded, below what it meets"});
    if (!sketch.curveWorld().empty()) legend.push_back({line, "#1a1a1a", "where it cuts other objects"});
    drawLegend(drawing, {{area.corner.x, area.corner.y + field.size.y}, {area.size.x, kLegend}}, legend, source.font);
    return {std::move(drawing), "The shadow volume of " + solid.object->name +
                                    ": its top cap, sides and bottom cap, and where it cuts other objects"};
}

} // namespace shadowlab::figures
