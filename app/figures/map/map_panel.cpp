// "Shadow map": the light's texels as fans in the plane through eye, light and point, each as deep as it holds; and the texels
// beside the point enlarged, with the receiver, the stored depths and the bias.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include "app/figures/inks.h"
#include "app/figures/panels.h"
#include "app/figures/section_sheet.h"
#include "techniques/foundation/base/look.h"
#include "techniques/probed/map_probe.h"

namespace shadowlab::figures {

namespace {

using Cell = MapProbe::Cell;

const std::string kFan = "#fbe9c0", kStored = ink::kLight, kCompared = ink::kAsked;

const Cell* cellOfPoint(const MapProbe& map) {
    const auto found = std::ranges::find(map.near, map.texel, &Cell::texel);
    return found == map.near.end() ? nullptr : &*found;
}

void drawOverview(drawing::Drawing& drawing, const drawing::Box& area, const Probe& probe, const scene::Scene& scene,
                  const image::Font& font) {
    const MapProbe& map = *probe.find<MapProbe>();
    std::vector<dvec2> places;
    if (map.blockerWorld) places.push_back(probe.section->of(*map.blockerWorld));
    const SectionSheet sheet(probe, scene, area, places);
    drawing::Labels labels(font, area);
    drawing.beginClip(area.corner, area.size);
    for (const Cell& cell : map.across)
        if (!cell.isEmpty)
            drawing.line(sheet(cell.rays[0]), sheet(0.5 * (cell.stored[0] + cell.stored[1])), {"#e0b450", 1.8, false});
    drawing.endClip();
    sheet.drawScene(drawing, labels);
    for (const Cell& cell : map.across) {
        const dvec2 at = 0.5 * (cell.stored[0] + cell.stored[1]);
        if (!cell.isEmpty && sheet.shows(at)) drawing.circle(sheet(at), 4, kStored, {"#ffffff", 0.5, false});
    }
    // Light to point, and what the texel holds on the way.
    const dvec2 point = sheet(dvec2(0.0));
    const bool isLit = map.compared <= map.stored;
    sheet.drawLines(drawing, labels, drawing::colorText(isLit ? look::kEqualDepth : look::kOccluded), 0.45);
    labels.place(drawing, point, "z = " + fourDigits(map.pointMetres) + " m", {.size = kText, .color = kCompared}, 16);
    if (map.blockerWorld) {
        const dvec2 place = probe.section->of(*map.blockerWorld);
        if (sheet.shows(place)) {
            drawing.circle(sheet(place), 8, kStored, {"#ffffff", 2, false}, "blocker");
            labels.avoid({sheet(place) - 9.0, dvec2(18)});
            labels.place(drawing, sheet(place), "d = " + fourDigits(map.firstMetres) + " m",
                         {.size = kText, .color = kStored}, 14);
        }
    }
    drawing.rectangle(area.corner, area.size, "none", {"#bfbfbf", 2, false});
}

void drawDetail(drawing::Drawing& drawing, const drawing::Box& area, const Probe& probe, const scene::Scene& scene,
                const image::Font& font) {
    const MapProbe& map = *probe.find<MapProbe>();
    double reach = 4 * map.texelMetres;
    for (const Cell& cell : map.near)
        for (const dvec2& place : cell.compared)
            if (glm::length(place) < 20 * map.texelMetres) reach = std::max(reach, glm::length(place));
    const SectionSheet sheet(probe, scene, area, reach);
    drawing::Labels labels(font, area);
    drawing.beginClip(area.corner, area.size);
    const dvec2 toward = sheet.light().toward(dvec2(0.0));
    for (const Cell& cell : map.near) {
        // From a little before the enlarged part: rays are as good as parallel there.
        std::array<dvec2, 2> starts{}, ends = cell.stored;
        for (std::size_t i = 0; i < 2; ++i) {
            starts[i] = cell.compared[i] + 4 * reach * toward;
            const dvec2 far = cell.compared[i] - 4 * reach * toward;
            if (cell.isEmpty || glm::dot(cell.stored[i], toward) < -4 * reach) ends[i] = far;
        }
        const bool isBefore = glm::dot(ends[0], toward) > 4 * reach; // it ends before the enlarged part begins
        if (isBefore) continue;
        drawing.path(std::array{sheet(starts[0]), sheet(starts[1]), sheet(ends[1]), sheet(ends[0])}, true, kFan,
                     {"#e0b450", 1.5, false});
    }
    for (const Cell& cell : map.near)
        if (!cell.isEmpty) drawing.line(sheet(cell.stored[0]), sheet(cell.stored[1]), {kStored, 6, false});
    drawing.endClip();
    sheet.drawScene(drawing, labels);
    drawing.beginClip(area.corner, area.size);
    for (const Cell& cell : map.near)
        drawing.line(sheet(cell.compared[0]), sheet(cell.compared[1]), {kCompared, 4, true});
    drawing.endClip();
    sheet.drawPoint(drawing, labels);
    const Cell* own = cellOfPoint(map);
    if (own && !own->isEmpty) {
        const dvec2 middle = 0.5 * (own->stored[0] + own->stored[1]);
        if (sheet.shows(middle))
            labels.place(drawing, sheet(middle), "d", {.size = kText, .isBold = true, .color = kStored}, 14);
        else
            labels.place(drawing, area.corner + dvec2(0.5 * area.size.x, 20),
                         "d is nearer to the light, beyond this detail", {.size = kText, .color = kStored}, 4);
    }
    drawing.rectangle(area.corner, area.size, "none", {"#bfbfbf", 2, false});
}

void writeMapNumbers(drawing::Drawing& drawing, const drawing::Box& area, const Probe& probe, const image::Font& font) {
    const MapProbe& map = *probe.find<MapProbe>();
    TextColumn column(drawing, area, font);
    const bool isInside = glm::all(glm::greaterThanEqual(map.texel, ivec2(0))) &&
                          glm::all(glm::lessThan(map.texel, ivec2(map.resolution)));
    const std::string texel = std::to_string(map.texel.x) + ", " + std::to_string(map.texel.y);
    column.heading((isInside ? "Texel " + texel + " of map " : "Outside of map ") + map.layerName);
    column.row("a texel is " + fourDigits(map.texelMetres) + " m wide at the point");
    // The two depths that are compared differ by little, which four digits would hide: so their difference is printed.
    if (map.stored >= 1) {
        column.row("d: nothing is stored", kStored);
    } else {
        column.row("d: the surface is at " + fourDigits(map.firstMetres) + " m", kStored);
        if (map.stored != map.first)
            column.row("stored " + fourDigits(map.storedMetres - map.firstMetres) + " m farther, by its slope",
                       kStored);
    }
    column.row("z: the point is at " + fourDigits(map.pointMetres) + " m", kCompared);
    column.row("compared " + fourDigits(map.pointMetres - map.comparedMetres) + " m nearer: the bias", kCompared);
    column.row(map.compared <= map.stored ? "d < z is not true: the comparison says lit"
                                          : "d < z: the comparison says in shadow");
    if (map.search) {
        column.row(std::to_string(map.search->found) + " of " + std::to_string(map.search->looks.size()) +
                   " depths looked at are blockers" +
                   (map.search->found
                        ? ", on average " + fourDigits(map.search->blockerMetres) +
                              " m from the light: a penumbra of " + fourDigits(map.search->penumbraMetres) + " m"
                        : ""));
    }
    if (map.moments)
        for (const MapProbe::Moments::Bound& bound : map.moments->bounds)
            column.row(bound.of + ": mean " + fourDigits(bound.mean) + ", variance " + fourDigits(bound.variance) +
                       ", the point's " + fourDigits(bound.compared) + ": lit at most " + fourDigits(bound.visibility));
    const auto lit = std::ranges::count(map.taps, true, &MapProbe::Tap::isLit);
    if (map.taps.size() > 1)
        column.row(std::to_string(lit) + " of the filter's " + std::to_string(map.taps.size()) +
                   " comparisons say lit");
    for (const Probe::Fact& fact : probe.facts)
        if (fact.label == "decision" || fact.label == "truth" || fact.label == "error" || fact.label == "who decides")
            column.row(fact.label + ": " + fact.value, fact.label == "error" ? "#a04000" : "#1a1a1a");
}

} // namespace

void drawMap(drawing::Drawing& drawing, const drawing::Box& area, const Probe& probe, const scene::Scene& scene,
             const image::Font& font) {
    constexpr double kTaps = 270, kWide = 1500;
    const bool isWide = area.size.x >= kWide;
    const double right = std::min(800.0, 0.44 * area.size.x), legendHeight = isWide ? 44 : 44 + kSheetRow;
    const bool taps = hasTaps(*probe.find<MapProbe>());
    const double detail = taps ? 420 : 480; // what the filter read takes more lines
    drawing.text(area.corner + dvec2(0, kHeading),
                 isWide ? "Shadow map in the plane through eye, light and point" : "Plane of eye, light and point",
                 {.size = kHeading, .isBold = true});
    const dvec2 under(0, kHeading + 18);
    const drawing::Box field{area.corner + under, area.size - dvec2(right + 30, kHeading + 18 + legendHeight + 14)};
    drawOverview(drawing, field, probe, scene, font);
    const dvec2 beside = area.corner + dvec2(area.size.x - right, 0);
    drawing.text(beside + dvec2(0, kHeading), "The texels beside the point", {.size = kHeading, .isBold = true});
    drawDetail(drawing, {beside + under, {right, detail}}, probe, scene, font);
    const drawing::Box below{beside + under + dvec2(0, detail + 16),
                    {right, area.size.y - kHeading - 18 - detail - 16 - legendHeight - 14}};
    writeMapNumbers(drawing, {below.corner, below.size - dvec2(taps ? kTaps + 24 : 0, 0)}, probe, font);
    if (taps)
        drawTaps(drawing, {below.corner + dvec2(right - kTaps, kHeading + 22), {kTaps, below.size.y - kHeading - 22}},
                 *probe.find<MapProbe>());
    using enum LegendEntry::Kind;
    const LegendEntry legend[] = {{LegendEntry::Kind::filled, kFan, "what a texel sees, up to its depth"},
                                  {line, kStored, "stored depth d, offset included"},
                                  {dashed, kCompared, "compared depth z, less the bias"},
                                  {line, "#4d4d4d", "caster"},
                                  {line, "#a6a6a6", "casts no shadow"}};
    drawLegend(drawing, {area.corner + dvec2(0, area.size.y - legendHeight), {area.size.x, legendHeight}}, legend, font);
}

} // namespace shadowlab::figures
