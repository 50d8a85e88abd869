// "Z-pass and z-fail": the eye's line through the point, the faces of shadow volumes that it crosses, and how many volumes each
// place of the plane is in. After the two figures of the lecture, from the scene as it is.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include "app/figures/panels.h"
#include "app/figures/volume/volume_marks.h"
#include "techniques/probed/volume_probe.h"

namespace shadowlab::figures {

namespace {

using Crossing = VolumeProbe::Crossing;

constexpr std::size_t kMarked = 14;   ///< crossings that are numbered; more could not be distinguished
constexpr double kGrid = 22;          ///< pixels between the places where the count is looked up, for its numbers
constexpr double kRoomForNumber = 34; ///< pixels around a number that have the same count

/// In each region of one count its number, where it has most room.
void writeCounts(drawing::Drawing& drawing, drawing::Labels& labels, const SectionSheet& sheet, const VolumeProbe& volume) {
    const drawing::Box metres = sheet.metres();
    const ivec2 cells = ivec2(sheet.area().size / kGrid);
    const auto index = [&](int x, int y) {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(cells.x) + static_cast<std::size_t>(x);
    };
    std::vector<int> counts(static_cast<std::size_t>(cells.x) * static_cast<std::size_t>(cells.y));
    for (int y = 0; y < cells.y; ++y)
        for (int x = 0; x < cells.x; ++x) {
            const dvec2 share = (dvec2(x, cells.y - 1 - y) + 0.5) / dvec2(cells);
            counts[index(x, y)] = countAt(metres.corner + share * metres.size, volume.caps, sheet.light());
        }
    // How many cells it is to the nearest one of another count, or to the border; and which region each is of.
    std::vector<int> room(counts.size(), 0), region(counts.size(), -1);
    for (int y = 0; y < cells.y; ++y)
        for (int x = 0; x < cells.x; ++x) {
            int reach = 0;
            for (bool same = true; same; ++reach)
                for (int dy = -reach; dy <= reach && same; ++dy)
                    for (int dx = -reach; dx <= reach && same; ++dx) {
                        const int nx = x + dx, ny = y + dy;
                        same = nx >= 0 && ny >= 0 && nx < cells.x && ny < cells.y &&
                               counts[index(nx, ny)] == counts[index(x, y)];
                    }
            room[index(x, y)] = reach - 1;
        }
    int regions = 0;
    std::vector<std::pair<int, int>> stack;
    for (int y = 0; y < cells.y; ++y)
        for (int x = 0; x < cells.x; ++x) {
            if (region[index(x, y)] >= 0) continue;
            std::size_t best = index(x, y);
            stack = {{x, y}};
            region[best] = regions;
            while (!stack.empty()) {
                const auto [cx, cy] = stack.back();
                stack.pop_back();
                if (room[index(cx, cy)] > room[best]) best = index(cx, cy);
                for (const auto& [dx, dy] : {std::pair(1, 0), std::pair(-1, 0), std::pair(0, 1), std::pair(0, -1)}) {
                    const int nx = cx + dx, ny = cy + dy;
                    if (nx < 0 || ny < 0 || nx >= cells.x || ny >= cells.y || region[index(nx, ny)] >= 0) continue;
                    if (counts[index(nx, ny)] != counts[best]) continue;
                    region[index(nx, ny)] = regions;
                    stack.emplace_back(nx, ny);
                }
            }
            ++regions;
            if (room[best] * kGrid < kRoomForNumber) continue;
            const dvec2 at =
                sheet.area().corner + (dvec2(static_cast<double>(best % static_cast<std::size_t>(cells.x)),
                                             static_cast<double>(best / static_cast<std::size_t>(cells.x))) +
                                       0.5) *
                                          sheet.area().size / dvec2(cells);
            labels.place(drawing, at, signedText(counts[best]), {.size = 1.3 * kText, .color = "#595959"}, 0);
        }
}

void drawLine(drawing::Drawing& drawing, drawing::Labels& labels, const SectionSheet& sheet) {
    const dvec2 point = sheet(dvec2(0.0));
    const dvec2 from = lineStart(sheet), to = lineEnd(sheet);
    drawing.line(from, point, {"#1a1a1a", 4, false});
    drawing.arrow(point, to, {"#1a1a1a", 4, true});
    labels.avoid(from, point);
    labels.avoid(point, to);
}

void drawCrossings(drawing::Drawing& drawing, drawing::Labels& labels, const SectionSheet& sheet, const VolumeProbe& volume) {
    std::size_t number = 0;
    std::vector<std::pair<dvec2, const Crossing*>> marks;
    for (const Crossing& crossing : volume.crossings) {
        if (++number > kMarked) break;
        if (std::isinf(crossing.distance) || !sheet.shows(placeOf(sheet, crossing))) continue;
        marks.emplace_back(sheet(placeOf(sheet, crossing)), &crossing);
        drawing.circle(marks.back().first, 8, signColor(crossing.sign), {"#ffffff", 2, false}, "crossing");
        labels.avoid({marks.back().first - 8.0, dvec2(16)});
    }
    for (const auto& [at, crossing] : marks) {
        const auto which = static_cast<std::size_t>(crossing - volume.crossings.data()) + 1;
        labels.place(drawing, at, std::to_string(which) + ": " + signedText(crossing->sign),
                     {.size = kText, .isBold = true, .color = signColor(crossing->sign)}, 14);
    }
}

std::string rowOf(const Crossing& crossing, std::size_t number) {
    const std::string of = crossing.part == VolumeProbe::Part::side
                               ? "side " + std::to_string(crossing.of[0]) + "\u2013" + std::to_string(crossing.of[1])
                               : (crossing.part == VolumeProbe::Part::topCap ? "top cap " : "bottom cap ") +
                                     std::to_string(crossing.of[0]);
    return std::to_string(number) + ": " + signedText(crossing.sign) + " " + crossing.object + ", " + of + ", " +
           (std::isinf(crossing.distance) ? "at infinity" : fourDigits(crossing.distance) + " m");
}

void writeVolumeNumbers(drawing::Drawing& drawing, const drawing::Box& area, const Probe& probe, const image::Font& font) {
    const VolumeProbe& volume = *probe.find<VolumeProbe>();
    TextColumn column(drawing, area, font);
    const auto verdict = [](int count) { return signedText(count) + (count == 0 ? ", illuminated" : ", in shadow"); };
    column.heading("Z-pass: eye to point");
    column.row("n_f = " + std::to_string(volume.frontsBefore) + ", n_b = " + std::to_string(volume.backsBefore) +
               ": n_f \u2212 n_b = " + verdict(volume.frontsBefore - volume.backsBefore));
    column.heading("Z-fail: point to infinity");
    column.row("n_b = " + std::to_string(volume.backsBeyond) + ", n_f = " + std::to_string(volume.frontsBeyond) +
               ": n_b \u2212 n_f = " + verdict(volume.backsBeyond - volume.frontsBeyond));
    column.row("The eye is in " + std::to_string(volume.eyeCount) + (volume.eyeCount == 1 ? " volume." : " volumes."));
    column.heading("This technique");
    column.row("count " + signedText(volume.count) + ", stencil " + std::to_string(volume.stencil));
    for (const Probe::Fact& fact : probe.facts)
        if (fact.label == "decision" || fact.label == "truth" || fact.label == "error")
            column.row(fact.label + ": " + fact.value, fact.label == "error" ? "#a04000" : "#1a1a1a");
    column.heading("Faces on the line");
    if (volume.crossings.empty())
        column.row("none");
    else
        column.row("sides by their edge, caps by their triangle", "#595959");
    std::size_t number = 0;
    for (const Crossing& crossing : volume.crossings) {
        ++number;
        if (number > kMarked || !column.hasRoom(3)) {
            column.row("and " + std::to_string(volume.crossings.size() - number + 1) + " more");
            break;
        }
        const bool isFirstBeyond = crossing.beyond && (number == 1 || !volume.crossings[number - 2].beyond);
        if (number == 1 && !crossing.beyond) column.row("before the point:");
        if (isFirstBeyond) column.row("beyond the point:");
        column.row(rowOf(crossing, number), signColor(crossing.sign));
        if (!crossing.uncounted.empty()) column.row("   not counted: " + crossing.uncounted);
    }
}

} // namespace

void drawVolume(drawing::Drawing& drawing, const drawing::Box& area, const Probe& probe, const scene::Scene& scene,
                const image::Font& font) {
    const VolumeProbe& volume = *probe.find<VolumeProbe>();
    constexpr double kNumbers = 610, kLegend = 76;
    drawing.text(area.corner + dvec2(0, kHeading), "Shadow volumes in the plane through eye, light and point",
                 {.size = kHeading, .isBold = true});
    const drawing::Box field{area.corner + dvec2(0, kHeading + 18),
                    area.size - dvec2(kNumbers + 30, kHeading + 18 + kLegend + 14)};
    std::vector<dvec2> places;
    const dvec2 eye = probe.section->of(probe.geometry[0].fromWorld), way = -glm::normalize(eye);
    for (const Crossing& crossing : volume.crossings)
        if (std::isfinite(crossing.distance)) places.push_back(eye + crossing.distance * way);
    const SectionSheet sheet(probe, scene, field, places);
    drawing::Labels labels(font, field);
    drawCountedAreas(drawing, sheet, volume);
    sheet.drawScene(drawing, labels);
    drawLine(drawing, labels, sheet);
    sheet.drawPoint(drawing, labels);
    sheet.drawEye(drawing, labels);
    sheet.drawLight(drawing, labels);
    drawCrossings(drawing, labels, sheet, volume);
    writeCounts(drawing, labels, sheet, volume);
    drawing.rectangle(field.corner, field.size, "none", {"#bfbfbf", 2, false});
    writeVolumeNumbers(
        drawing, {area.corner + dvec2(area.size.x - kNumbers, 0), {kNumbers, area.size.y - kLegend - 20}}, probe, font);
    using enum LegendEntry::Kind;
    const LegendEntry legend[] = {{LegendEntry::Kind::filled, countFill(1), "in 1 volume"},
                                  {LegendEntry::Kind::filled, countFill(2), "in 2"},
                                  {LegendEntry::Kind::filled, countFill(3), "in 3"},
                                  {LegendEntry::Kind::filled, countFill(4), "in 4 or more"},
                                  {dot, signColor(1), "+1: front face, the line enters"},
                                  {dot, signColor(-1), "\u22121: back face, it leaves"},
                                  {line, "#1a1a1a", "z-pass"},
                                  {dashed, "#1a1a1a", "z-fail"},
                                  {line, "#4d4d4d", "caster"},
                                  {line, "#a6a6a6", "casts no shadow"}};
    drawLegend(drawing, {area.corner + dvec2(0, area.size.y - kLegend), {area.size.x, kLegend}}, legend, font);
}

} // namespace shadowlab::figures
