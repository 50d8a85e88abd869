// "The shadowed regions": the eye's line passes a silhouette polygon that faces the eye, +1, and ends on a polygon of the scene.
// SPDX-License-Identifier: MIT
#include <algorithm>

#include "app/figures/figure_drawers.h"
#include "app/figures/panels.h"
#include "app/figures/volume/volume_marks.h"
#include "app/figures/volume/volume_sketch.h"
#include "techniques/foundation/base/error.h"
#include "techniques/probed/volume_probe.h"

namespace shadowlab::figures {

namespace {

using Crossing = VolumeProbe::Crossing;

constexpr double kPlusOneLines = 56; ///< pixels; kPlusOneLines: of the text under the drawing

/// The sides of that caster's volume between eye and point, in order.
std::vector<const Crossing*> sidesBefore(const VolumeProbe& volume, const CasterSolid& solid) {
    std::vector<const Crossing*> sides;
    for (const Crossing& crossing : volume.crossings)
        if (crossing.part == VolumeProbe::Part::side && !crossing.beyond && crossing.object == solid.object->name)
            sides.push_back(&crossing);
    return sides;
}

bool isIn(const drawing::Box& box, dvec2 place) {
    return glm::all(glm::greaterThan(place, box.corner)) && glm::all(glm::lessThan(place, box.corner + box.size));
}

/// The eye, or so much of the way to it as fits into the field.
dvec3 drawnEye(const SpaceView& view, const drawing::Box& field, const dvec3& pointWorld, const dvec3& eyeWorld) {
    constexpr int kSteps = 400;
    const drawing::Box inner{field.corner + 24.0, field.size - 48.0};
    dvec3 last = pointWorld;
    for (int i = 1; i <= kSteps; ++i) {
        const dvec3 place = glm::mix(pointWorld, eyeWorld, static_cast<double>(i) / kSteps);
        if (view.depth(place) <= 0 || !isIn(inner, view(place))) break;
        last = place;
    }
    return last;
}

} // namespace

Diagram drawPlusOneFigure(const FigureSource& source) {
    const CasterSolid solid = casterSolid(source, true);
    const std::vector<const Crossing*> sides = sidesBefore(*source.probe.find<VolumeProbe>(), solid);
    if (sides.empty())
        throw Error(ExitStatus::badInput, "no side of the volume of " + solid.object->name +
                                              " lies between the eye and the pixel; choose one farther in its shadow");
    drawing::Drawing drawing(source.size);
    const drawing::Box area{dvec2(kSectionBorder), source.size - 2 * kSectionBorder},
        field{area.corner, area.size - dvec2(0, kPlusOneLines)};
    const VolumeSketch sketch(source, solid, field);
    const SpaceView& view = sketch.view();
    drawing::Labels labels(source.fonts(), field);
    sketch.drawReceivers(drawing);
    sketch.drawVolume(drawing, labels, 0.5, 0.16);
    const dvec3 eye = source.probe.geometry[0].fromWorld, point = source.probe.geometry[0].toWorld;
    const dvec3 way = glm::normalize(point - eye);
    int count = 0;
    for (const Crossing* side : sides) {
        const std::array corners{view(solid.verticesWorld[side->of[0]]), view(solid.verticesWorld[side->of[1]]),
                                 view(sketch.firstMet(side->of[1])), view(sketch.firstMet(side->of[0]))};
        drawing.surface(std::array{corners[0], corners[1], corners[2], corners[0], corners[2], corners[3]},
                        signColor(side->sign), 0.6);
        drawing.path(corners, true, "none", {signColor(side->sign), 3, false});
        count += side->sign;
    }
    const dvec3 from = drawnEye(view, field, point, eye);
    const dvec2 at = view(point), start = view(from);
    drawing.arrow(start, at, {"#1a1a1a", 5, false}, 0.35);
    labels.avoid(start, at);
    drawing.circle(at, 9, "#1a1a1a", {"#ffffff", 2, false}, "point");
    labels.avoid({at - 10.0, dvec2(20)});
    for (const Crossing* side : sides) {
        const dvec2 mark = view(eye + side->distance * way);
        drawing.circle(mark, 11, signColor(side->sign), {"#ffffff", 2, false}, "crossing");
        labels.avoid({mark - 12.0, dvec2(24)});
    }
    sketch.drawLight(drawing, labels, false);
    const bool isEye = glm::length(from - eye) < 1e-9;
    if (isEye) drawing.circle(start, 11, "#ffffff", {"#1a1a1a", 4, false}, "eye");
    const drawing::TextStyle style{.size = kText, .isBold = true};
    for (const Crossing* side : sides)
        labels.place(drawing, view(eye + side->distance * way), signedText(side->sign) + " silhouette polygon",
                     {.size = kHeading, .isBold = true, .color = signColor(side->sign)}, 16);
    labels.place(drawing, at, "scene polygon", {.size = kHeading, .isBold = true}, 14);
    labels.place(drawing, start, isEye ? "eye" : "from the eye", style, 14);
    const std::string sum = "Count: " + signedText(count) + (count == 0 ? ": illuminated" : ": in shadow");
    drawing.text(area.corner + dvec2(0, area.size.y - 12), sum, {.size = 36, .isBold = true});
    return {std::move(drawing), "The shadow volume of " + solid.object->name +
                                    ", the polygons of its side that the eye's line passes, and where it ends"};
}

} // namespace shadowlab::figures
