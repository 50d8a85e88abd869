// "Z-pass" and "z-fail" as the lecture draws them: the segment from the point to the view point, or the ray that runs away from
// it, the volume faces that it crosses, and n_f and n_b.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "app/drawing/formula.h"
#include "app/figures/figure_drawers.h"
#include "app/figures/panels.h"
#include "app/figures/volume/volume_marks.h"
#include "techniques/foundation/base/error.h"
#include "techniques/foundation/base/look.h"
#include "techniques/probed/volume_probe.h"

namespace shadowlab::figures {

namespace {

using Crossing = VolumeProbe::Crossing;

constexpr double kCountFormulaEm = 36, kCountRow = 44;
constexpr double kCountLines = 2 * kCountRow + 66; ///< pixels of formula, verdict and legend under the drawing
constexpr std::size_t kMostMarks = 10;             ///< crossings with a sign beside them: more cover one another

/// The lines of the lecture's algorithm: n_f and n_b of the technique's own way.
struct Counts {
    bool isPass = true;
    int fronts = 0, backs = 0;
};
Counts countsOf(const FigureSource& source) {
    const VolumeProbe& volume = *source.probe.find<VolumeProbe>();
    const bool passes = std::ranges::all_of(
        volume.crossings, [](const Crossing& crossing) { return crossing.method == CountMethod::zPass; });
    if (source.technique != "shadow-volume-zfail" && passes) return {true, volume.frontsBefore, volume.backsBefore};
    return {false, volume.frontsBeyond, volume.backsBeyond};
}

void drawCountedCrossings(drawing::Drawing& drawing, drawing::Labels& labels, const SectionSheet& sheet, const VolumeProbe& volume,
                          const Counts& counts) {
    std::vector<std::pair<dvec2, int>> marks;
    for (const Crossing& crossing : volume.crossings) {
        if (crossing.beyond == counts.isPass || std::isinf(crossing.distance)) continue;
        if (!sheet.shows(placeOf(sheet, crossing))) continue;
        const dvec2 at = sheet(placeOf(sheet, crossing));
        drawing.circle(at, 11, signColor(crossing.sign), {"#ffffff", 2, false}, "crossing");
        labels.avoid({at - 11.0, dvec2(22)});
        marks.emplace_back(at, crossing.sign);
    }
    for (std::size_t i = 0; i < std::min(marks.size(), kMostMarks); ++i)
        labels.place(drawing, marks[i].first, signedText(marks[i].second),
                     {.size = drawing::kLetter, .isBold = true, .color = signColor(marks[i].second)}, 14);
}

void drawEyeLine(drawing::Drawing& drawing, drawing::Labels& labels, const SectionSheet& sheet, bool isPass) {
    const dvec2 point = sheet(dvec2(0.0)), from = lineStart(sheet), to = lineEnd(sheet);
    const drawing::Stroke counted{"#1a1a1a", 5, false}, other{"#8c8c8c", 2.5, true};
    if (isPass)
        drawing.arrow(from, point, counted, 0.4);
    else
        drawing.line(from, point, other);
    if (!isPass) drawing.arrow(point, to, counted);
    labels.avoid(from, point);
    if (!isPass) labels.avoid(point, to);
}

/// Where the light's way to the eye meets the first caster, in metres of the plane; none: the eye is lit.
std::optional<dvec2> aboveEye(const FigureSource& source, dvec2 eye) {
    const LightSection& section = *source.probe.section;
    const Probe::Segment& toLight = source.probe.geometry[1];
    const dvec2 way = toLight.isEndless ? section.ofDirection(toLight.toWorld - toLight.fromWorld) : section.of(toLight.toWorld) - eye;
    scene::Scene casters = source.scene;
    std::erase_if(casters.objects, [](const scene::Object& object) { return !object.castsShadow; });
    const std::vector<dvec2> lines = cut(casters, {section.originWorld, section.rightWorld, section.upWorld});
    double nearest = toLight.isEndless ? std::numeric_limits<double>::infinity() : 1; // in lengths of the way
    std::optional<dvec2> place;
    for (std::size_t i = 0; i + 1 < lines.size(); i += 2) {
        const dvec2 along = lines[i + 1] - lines[i], from = lines[i] - eye;
        const double turn = way.x * along.y - way.y * along.x;
        const double distance = (from.x * along.y - from.y * along.x) / turn, share = (from.x * way.y - from.y * way.x) / turn;
        if (!(distance > 0 && distance < nearest && share >= 0 && share <= 1)) continue; // false for parallels, too
        nearest = distance;
        place = eye + distance * way;
    }
    return place;
}

} // namespace

Diagram drawCountFigure(const FigureSource& source) {
    const Probe& probe = source.probe;
    if (probe.geometry.empty()) throw Error(ExitStatus::badInput, "the pixel shows the background; choose another");
    if (!probe.find<VolumeProbe>() || !hasSection(probe))
        throw Error(ExitStatus::badInput, std::string(source.technique) +
                                              " counts no faces of volumes there; ask shadow-volume-zpass or "
                                              "shadow-volume-zfail, in a scene with a light");
    const VolumeProbe& volume = *probe.find<VolumeProbe>();
    const Counts counts = countsOf(source);
    drawing::Drawing drawing(source.size);
    const drawing::Box area{dvec2(kSectionBorder), source.size - 2 * kSectionBorder},
        field{area.corner, area.size - dvec2(0, kCountLines)};
    std::vector<dvec2> places;
    const dvec2 eye = probe.section->of(probe.geometry[0].fromWorld);
    for (const Crossing& crossing : volume.crossings)
        if (std::isfinite(crossing.distance)) places.push_back(eye - crossing.distance * glm::normalize(eye));
    // What the eye is in the shadow of explains its count.
    if (volume.eyeCount > 0)
        if (const std::optional<dvec2> above = aboveEye(source, eye)) places.push_back(*above);
    const SectionSheet sheet(probe, source.scene, field, places, source.mostPixelsPerMetre);
    drawing::Labels labels(source.fonts(), field);
    drawCountedAreas(drawing, sheet, volume);
    sheet.drawScene(drawing, labels);
    drawEyeLine(drawing, labels, sheet, counts.isPass);
    const auto truth = std::ranges::find(probe.facts, "truth", &Probe::Fact::label);
    const std::string isTrue = truth == probe.facts.end() ? "" : truth->value;
    const bool isLit = isTrue == "lit";
    sheet.drawPoint(drawing, labels, isLit ? "illuminated" : isTrue == "turned away" ? "turned away" : "shadowed");
    drawCountedCrossings(drawing, labels, sheet, volume, counts);
    sheet.drawEye(drawing, labels);
    sheet.drawLight(drawing, labels);
    drawing.rectangle(field.corner, field.size, "none", {"#bfbfbf", 2, false});

    const bool isEqual = counts.fronts == counts.backs;
    const std::string number = "n_f = " + std::to_string(counts.fronts) +
                               ", \\quad n_b = " + std::to_string(counts.backs) + ", \\quad n_f " +
                               (isEqual ? "=" : "\\ne") + " n_b";
    const drawing::FormulaFonts fonts = source.fonts();
    const dvec2 foot = area.corner + dvec2(0, field.size.y + kCountRow);
    const drawing::Extent extent = drawing::Formula(number).draw(drawing, foot, kCountFormulaEm, "#1a1a1a", fonts);
    drawing.text(foot + dvec2(extent.width + 24, 0), isEqual ? ": illuminated" : ": in shadow",
                 {.size = kCountFormulaEm, .isBold = true});
    std::string remark;
    if (isTrue == "turned away")
        remark = "The surface is turned away from the light, and dark for that.";
    else if (isLit != isEqual)
        remark = "In truth the point is " + std::string(isLit ? "illuminated" : "in shadow") +
                 ": the view point is in " + std::to_string(volume.eyeCount) +
                 (volume.eyeCount == 1 ? " volume." : " volumes.");
    else if (volume.eyeCount > 0)
        remark = "The view point is in " + std::to_string(volume.eyeCount) +
                 (volume.eyeCount == 1 ? " volume itself." : " volumes itself.");
    drawing.text(foot + dvec2(0, kCountRow - 4), remark,
                 {.size = kText, .isBold = isLit != isEqual, .color = isLit != isEqual ? "#a04000" : "#4d4d4d"});
    using enum LegendEntry::Kind;
    const LegendEntry legend[] = {
        {filled, countFill(1), "shadow volume"}, {dot, signColor(1), "front face"}, {dot, signColor(-1), "back face"}};
    drawLegend(drawing, {area.corner + dvec2(0, area.size.y - 42), {area.size.x, 42}}, legend, source.font);
    return {std::move(drawing), std::string(counts.isPass ? "Z-pass: the segment from the point to the view point"
                                                          : "Z-fail: the ray from the point away from the view point") +
                                    ", and the faces of shadow volumes that it crosses",
            sheet.scale()};
}

} // namespace shadowlab::figures
