// "Space subdivision": the cells of a grid, seen along an axis; those on the pixel's ray in their order, and what each of them lists.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <map>

#include "app/figures/axis_view.h"
#include "app/figures/figure_drawers.h"
#include "app/figures/figure_parts.h"
#include "app/figures/panels.h"
#include "app/figures/section_sheet.h"
#include "techniques/foundation/base/error.h"
#include "techniques/foundation/base/look.h"
#include "techniques/probed/structure_probe.h"

namespace shadowlab::figures {

namespace {

constexpr double kListWidth = 560, kListText = 28;
constexpr double kLeastLine = 5;                                  ///< pixels between lines: finer grids are a grey area
constexpr double kLeastNumber = 34;                               ///< pixels of a cell that a number fits into
const char *const kPassed = "#d6ebf7", *const kHolds = "#fdf3dc"; // light tints of look::kVisited and look::kPatchJ

/// Lines of the grid along the two axes that are seen.
void drawLines(drawing::Drawing& drawing, const ParallelView& view, const StructureProbe& grid, int axis) {
    std::vector<dvec2> lines;
    for (int along = 0; along < 3; ++along) {
        if (along == axis) continue;
        const int across = 3 - axis - along;
        const double step = (grid.upperWorld[along] - grid.lowerWorld[along]) / grid.counts[along];
        if (step * view.scale() < kLeastLine) continue;
        for (int i = 0; i <= grid.counts[along]; ++i) {
            dvec3 from = grid.lowerWorld, to = grid.lowerWorld;
            from[along] = to[along] = grid.lowerWorld[along] + i * step;
            to[across] = grid.upperWorld[across];
            lines.insert(lines.end(), {view(from), view(to)});
        }
    }
    drawing.segments(lines, {"#b3b3b3", 1.5, false});
}

void writeLists(drawing::Drawing& drawing, const drawing::Box& area, const StructureProbe& grid, const image::Font& font) {
    TextColumn column(drawing, area, font, kListText);
    column.heading("Cells on the ray's way");
    for (std::size_t i = 0; i < grid.cells.size(); ++i) {
        std::string text = std::to_string(i + 1) + ": ";
        for (std::size_t j = 0; j < grid.cells[i].objects.size(); ++j)
            text += (j == 0 ? "" : ", ") + grid.cells[i].objects[j];
        if (grid.cells[i].objects.empty()) text += "empty, nothing is tested";
        if (!column.hasRoom(4)) {
            column.row("... and " + counted(grid.cells.size() - i, "more", "more"));
            break;
        }
        column.row(text);
    }
}

} // namespace

Diagram drawGrid(const FigureSource& source) {
    const Probe::Segment& ray = eyeRayOf(source);
    const auto* const structure = source.probe.find<StructureProbe>();
    if (!structure || structure->cells.empty())
        throw Error(ExitStatus::badInput, "no cells are there to draw; ask ray-traced, with ray-traced.structure=grid");
    const StructureProbe& grid = *structure;
    const int axis = axisAcross(ray.toWorld - ray.fromWorld);
    drawing::Drawing drawing(source.size);
    const drawing::Box below =
        writeFoot(drawing, roomOf(source),
                  std::to_string(grid.counts.x) + " x " + std::to_string(grid.counts.y) + " x " +
                      std::to_string(grid.counts.z) + " cells, seen " + axisWords(axis) +
                      ". Blue cells are empty. Only the objects that the others list are tested, cell by cell, until one is hit. "
                      "Things drawn in a blue cell lie before it or behind it.",
                  source.font);
    const drawing::Box area{below.corner, {below.size.x - kListWidth - 20, below.size.y}};
    ParallelView view = viewAlong(axis, source.view.camera);
    std::vector<dvec3> places{grid.lowerWorld, grid.upperWorld};
    const double size = glm::length(grid.upperWorld - grid.lowerWorld);
    const dvec3 way = ray.toWorld - ray.fromWorld, entry = grid.cells.front().lowerWorld;
    // The eye is drawn if it is not far before the grid; else the ray begins a little before it.
    const bool isCut = glm::length(ray.fromWorld - 0.5 * (grid.lowerWorld + grid.upperWorld)) > 0.9 * size;
    dvec3 fromWorld = ray.fromWorld;
    if (isCut)
        fromWorld = ray.toWorld -
                    glm::normalize(way) * std::min(glm::length(way), glm::length(ray.toWorld - entry) + 0.12 * size);
    places.push_back(fromWorld);
    view.fit(places, {area.corner + dvec2(12, 12), area.size - dvec2(24, 30)});
    drawing::Labels labels(source.fonts(), area);
    std::map<std::pair<long, long>, std::string> numbers; // cells behind each other share a place
    std::map<std::pair<long, long>, drawing::Box> boxes;
    for (std::size_t i = 0; i < grid.cells.size(); ++i) {
        const drawing::Box box = rectangleOf(view, grid.cells[i].lowerWorld, grid.cells[i].upperWorld);
        const std::pair key(std::lround(box.corner.x), std::lround(box.corner.y));
        numbers[key] += (numbers[key].empty() ? "" : ", ") + std::to_string(i + 1);
        boxes[key] = box;
        drawing.rectangle(box.corner, box.size, grid.cells[i].objects.empty() ? kPassed : kHolds,
                          {"#1a1a1a", 2.5, false});
    }
    drawLines(drawing, view, grid, axis);
    for (const auto& [key, box] : boxes)
        drawing.rectangle(box.corner, box.size, "", {"#1a1a1a", 2.5, false});
    for (const scene::Object& object : source.scene.objects)
        if (object.emitterOfLight < 0) drawObject(drawing, area, view, object, {"#4d4d4d", 3, false}, &labels);
    const dvec2 from = view(fromWorld), to = view(ray.toWorld);
    drawing.arrow(from, to, {drawing::colorText(look::kDepthFail), 4.5, false});
    labels.avoid(from, to);
    if (isCut)
        drawing.breakMark(glm::mix(from, to, 0.05), to - from, {drawing::colorText(look::kDepthFail), 3, false});
    else
        drawing.circle(from, 9, "#ffffff", {"#1a1a1a", 4, false}, "eye");
    drawing.circle(to, 8, "#1a1a1a", {"#ffffff", 2, false}, "surface");
    labels.avoid({to - 9.0, dvec2(18)});
    for (const auto& [key, text] : numbers) {
        const drawing::Box& box = boxes[key];
        if (std::min(box.size.x, box.size.y) < kLeastNumber) continue;
        labels.place(drawing, box.corner + dvec2(0.5, 0.25) * box.size, text, {.size = kText, .isBold = true}, 2);
    }
    labels.place(drawing, glm::mix(from, to, 0.1), "Pixel ray", {.size = kText, .isBold = true}, 12);
    writeLists(drawing, {below.corner + dvec2(below.size.x - kListWidth, 0), {kListWidth, below.size.y}}, grid,
               source.font);
    return {std::move(drawing),
            "The cells of a grid, those on a ray's way numbered, and the objects that each of them lists"};
}

} // namespace shadowlab::figures
