// "Shadow volume": an enclosed region of space that is formed by extruding an object's outline from the light source; and where it
// cuts other objects.
// SPDX-License-Identifier: MIT
#include "app/figures/figure_drawers.h"
#include "app/figures/panels.h"
#include "app/figures/volume/volume_sketch.h"

namespace shadowlab::figures {

namespace {

constexpr double kNoteHeight = 40; ///< pixels of the line under the drawing

} // namespace

Diagram drawVolumeFigure(const FigureSource& source) {
    const CasterSolid solid = casterSolid(source, true);
    drawing::Drawing drawing(source.size);
    const drawing::Box area{dvec2(kSectionBorder), source.size - 2 * kSectionBorder},
        field{area.corner, area.size - dvec2(0, kNoteHeight)};
    const VolumeSketch sketch(source, solid, field);
    drawing::Labels labels(source.fonts(), field);
    sketch.drawReceivers(drawing);
    sketch.drawVolume(drawing, labels, 0, 0.4);
    sketch.drawLight(drawing, labels, true);
    sketch.nameParts(drawing, labels);
    // The parts have their names beside them. What is not seen is said.
    const char* note = sketch.isCutOff()               ? "The bottom cap lies beyond this drawing."
                       : !sketch.curveWorld().empty() ? "The bottom cap lies below what the volume meets."
                                                       : "";
    drawing.text(area.corner + dvec2(0, area.size.y - 10), note, {.size = kText, .color = "#4d4d4d"});
    return {std::move(drawing), "The shadow volume of " + solid.object->name +
                                    ": its top cap, sides and bottom cap, and where it cuts other objects"};
}

} // namespace shadowlab::figures
