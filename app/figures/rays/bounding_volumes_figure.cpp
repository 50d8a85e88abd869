// "Bounding volumes": those around groups of objects with a ray that enters some of them, and beside them their tree.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

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

using Volume = StructureProbe::Volume;

constexpr double kTreeShare = 0.44, kNode = 24; ///< of the width; pixels: radius of a node
constexpr double kTreeRow = 2.45 * kNode;       ///< between nodes of the last level
constexpr std::size_t kMostLeaves = 16;         ///< two for each letter's size on a slide
constexpr double kLongTimes = 2.5;              ///< the ray is cut where it would make the volumes small

/// What happened to a volume.
enum class Answer { entered, missed, spared };
Answer answerOf(const Volume& volume) {
    if (!volume.isAsked) return Answer::spared;
    return volume.isEntered ? Answer::entered : Answer::missed;
}
drawing::Stroke strokeOfAnswer(Answer answer) {
    if (answer == Answer::entered) return {drawing::colorText(look::kDepthFail), 4, false};
    if (answer == Answer::missed) return {drawing::colorText(look::kOccluded), 3.5, true};
    return {"#8c8c8c", 2.5, true};
}

/// "A", "B" ... "Z", "A1", "B1" ...
std::string letterOf(std::size_t i) {
    std::string letter(1, static_cast<char>('A' + i % 26));
    return i < 26 ? letter : letter + std::to_string(i / 26);
}

/// Whole levels, as many as the tree has room for. They stand level by level, so that is a number of volumes.
std::vector<Volume> shownVolumes(const StructureProbe& structure, double height) {
    const auto most = std::min(kMostLeaves, static_cast<std::size_t>(height / kTreeRow));
    std::vector<Volume> shown;
    std::size_t begin = 0;
    while (begin < structure.volumes.size()) {
        std::size_t end = begin;
        while (end < structure.volumes.size() && structure.volumes[end].level == structure.volumes[begin].level)
            ++end;
        if (end - begin > most && !shown.empty()) break;
        if (end - begin > most)
            throw Error(ExitStatus::badInput, "there are " + std::to_string(end - begin) +
                                                  " volumes beside each other, too many to be drawn; choose another "
                                                  "structure or scene");
        shown.insert(shown.end(), structure.volumes.begin() + static_cast<std::ptrdiff_t>(begin),
                     structure.volumes.begin() + static_cast<std::ptrdiff_t>(end));
        begin = end;
    }
    return shown;
}

void drawVolumes(drawing::Drawing& drawing, const drawing::Box& area, const FigureSource& source, const std::vector<Volume>& volumes) {
    const Probe::Segment& ray = source.probe.geometry.front();
    const dvec3 way = ray.toWorld - ray.fromWorld;
    ParallelView view = viewAlong(axisAcross(way), source.view.camera);
    std::vector<dvec3> places{ray.toWorld};
    scene::Bounds all;
    for (const Volume& volume : volumes) {
        places.insert(places.end(), {volume.lowerWorld, volume.upperWorld});
        all.include(volume.lowerWorld);
        all.include(volume.upperWorld);
    }
    const double size = glm::length(all.upperWorld - all.lowerWorld), length = glm::length(way);
    const bool isCut = length > kLongTimes * size;
    const dvec3 fromWorld = isCut ? ray.toWorld - way * (0.7 * size / length) : ray.fromWorld;
    places.push_back(fromWorld);
    view.fit(places, {area.corner + dvec2(50, 50), area.size - dvec2(100, 100)});
    drawing::Labels labels(source.fonts(), area);
    for (const scene::Object& object : source.scene.objects)
        if (object.emitterOfLight < 0) drawObject(drawing, area, view, object, {"#b3b3b3", 2.5, false});
    for (const Volume& volume : volumes) {
        const drawing::Stroke stroke = strokeOfAnswer(answerOf(volume));
        const drawing::Box box = rectangleOf(view, volume.lowerWorld, volume.upperWorld);
        if (volume.isBall) {
            std::vector<dvec2> circle; // as a line, which can be dashed
            for (int i = 0; i < 72; ++i)
                circle.push_back(box.corner + 0.5 * box.size +
                                 view.scale() * volume.radius *
                                     dvec2(std::cos(M_PI * i / 36), std::sin(M_PI * i / 36)));
            drawing.path(circle, true, "", stroke);
            continue;
        }
        const dvec2 right(box.size.x, 0);
        const std::vector<dvec2> rim{box.corner, box.corner + right, box.corner + box.size,
                                     box.corner + box.size - right};
        drawing.path(rim, true, "", stroke);
        for (std::size_t i = 0; i < 4; ++i)
            labels.avoid(rim[i], rim[(i + 1) % 4]);
    }
    const dvec2 from = view(fromWorld), to = view(ray.toWorld);
    drawing.arrow(from, to, {"#1a1a1a", 4.5, false});
    if (isCut)
        drawing.breakMark(glm::mix(from, to, 0.08), to - from, {"#1a1a1a", 3, false});
    else
        drawing.circle(from, 9, "#ffffff", {"#1a1a1a", 4, false}, "eye");
    drawing.circle(to, 7, "#1a1a1a", {"#ffffff", 2, false}, "surface");
    labels.avoid(from, to);
    labels.avoid({to - 8.0, dvec2(16)});
    for (std::size_t i = 0; i < volumes.size(); ++i) {
        const drawing::Box box = rectangleOf(view, volumes[i].lowerWorld, volumes[i].upperWorld);
        const double radius = volumes[i].isBall ? 0.5 * box.size.x : 0;
        // On the rim: of a ball upper right, of a box one of its upper corners.
        const dvec2 at = volumes[i].isBall ? box.corner + 0.5 * box.size + radius * dvec2(0.707, -0.707)
                                           : box.corner + dvec2(i % 2 == 0 ? 0.0 : box.size.x, 0);
        labels.place(drawing, at, letterOf(i),
                     {.size = kText, .isBold = true, .color = strokeOfAnswer(answerOf(volumes[i])).color}, 4);
    }
    labels.place(drawing, glm::mix(from, to, 0.3), "Pixel ray", {.size = kText, .isBold = true}, 10);
}

/// The tree lies on its side: every leaf has a row, and room for a name.
class Tree {
public:
    explicit Tree(const std::vector<Volume>& volumes) : volumes_(volumes), rows_(volumes.size()) {
        for (std::size_t i = 0; i < volumes.size(); ++i)
            if (volumes[i].parent < 0) place(i);
        for (const Volume& volume : volumes)
            levels_ = std::max(levels_, volume.level + 1);
    }
    [[nodiscard]] double row(std::size_t i) const { return rows_[i]; }
    [[nodiscard]] double rows() const { return next_; }
    [[nodiscard]] int levels() const { return levels_; }

private:
    void place(std::size_t i) {
        double first = -1, last = -1;
        for (std::size_t child = i + 1; child < volumes_.size(); ++child) {
            if (volumes_[child].parent != static_cast<int>(i)) continue;
            place(child);
            last = rows_[child];
            if (first < 0) first = last;
        }
        rows_[i] = first < 0 ? next_++ : 0.5 * (first + last);
    }
    const std::vector<Volume>& volumes_;
    std::vector<double> rows_;
    double next_ = 0;
    int levels_ = 0;
};

void drawTree(drawing::Drawing& drawing, const drawing::Box& area, const std::vector<Volume>& volumes, const image::Font& font) {
    const Tree tree(volumes);
    const double names = 230, row = std::min(area.size.y / tree.rows(), 2 * kTreeRow);
    const double column = (area.size.x - names - 4 * kNode) / std::max(1, tree.levels());
    const double top = area.corner.y + 0.5 * (area.size.y - row * tree.rows());
    const auto at = [&](std::size_t i) {
        return dvec2(area.corner.x + kNode + 4 + column * (volumes[i].level + 1), top + row * (tree.row(i) + 0.5));
    };
    // One that holds all, where none of them does.
    const auto roots = std::ranges::count(volumes, -1, &Volume::parent);
    const dvec2 whole(area.corner.x + kNode + 4, top + 0.5 * row * tree.rows());
    for (std::size_t i = 0; i < volumes.size(); ++i)
        if (volumes[i].parent >= 0 || roots > 1)
            drawing.line(volumes[i].parent >= 0 ? at(static_cast<std::size_t>(volumes[i].parent)) : whole, at(i),
                         {"#1a1a1a", 2.5, false});
    if (roots > 1) {
        drawing.circle(whole, kNode, "#ffffff", {"#1a1a1a", 3, false}, "scene");
        drawing.text(whole + dvec2(-kNode + 4, kNode + kText + 6), "scene", {.size = kText, .anchor = drawing::Anchor::middle});
    }
    for (std::size_t i = 0; i < volumes.size(); ++i) {
        drawing::Stroke stroke = strokeOfAnswer(answerOf(volumes[i]));
        stroke.isDashed = false;
        const bool isSpared = !volumes[i].isAsked;
        drawing.circle(at(i), kNode, isSpared ? "#f2f2f2" : "#ffffff", stroke,
                       volumes[i].isEntered && !isSpared ? "entered" : "not entered");
        drawing.text(at(i) + dvec2(0, 9), letterOf(i),
                     {.size = kText, .anchor = drawing::Anchor::middle, .isBold = true, .color = stroke.color, .hasRim = false});
        if (!volumes[i].object.empty())
            drawing.text(at(i) + dvec2(kNode + 12, 9),
                         font.wrap(volumes[i].object, kText, static_cast<int>(names)).front(),
                         {.size = kText, .color = isSpared ? "#8c8c8c" : "#1a1a1a"});
    }
}

} // namespace

Diagram drawBoundingVolumes(const FigureSource& source) {
    eyeRayOf(source);
    const auto* const structure = source.probe.find<StructureProbe>();
    if (!structure || structure->volumes.empty())
        throw Error(ExitStatus::badInput, "no bounding volumes are there to draw; ask ray-traced, with "
                                          "ray-traced.structure=groups or another that has volumes");
    drawing::Drawing drawing(source.size);
    const std::vector<Volume>& all = structure->volumes;
    const auto asked = std::ranges::count(all, true, &Volume::isAsked);
    const int axis = axisAcross(source.probe.geometry.front().toWorld - source.probe.geometry.front().fromWorld);
    const drawing::Box below =
        writeFoot(drawing, roomOf(source),
                  "Seen " + axisWords(axis) + ". On the ray's way to the first surface " + std::to_string(asked) +
                      " of " + std::to_string(all.size()) + " volumes are tested: those in one that it misses are not.",
                  source.font);
    const LegendEntry legend[] = {{LegendEntry::Kind::line, drawing::colorText(look::kDepthFail), "entered"},
                                  {LegendEntry::Kind::dashed, drawing::colorText(look::kOccluded), "tested and missed"},
                                  {LegendEntry::Kind::dashed, "#8c8c8c", "never tested"}};
    drawLegend(drawing, {below.corner, {below.size.x, 40}}, legend, source.font);
    const drawing::Box room{below.corner + dvec2(0, 44), below.size - dvec2(0, 44)};
    const std::vector<Volume> volumes = shownVolumes(*structure, room.size.y);
    const double tree = kTreeShare * room.size.x;
    drawVolumes(drawing, {room.corner, {room.size.x - tree - 20, room.size.y}}, source, volumes);
    drawTree(drawing, {room.corner + dvec2(room.size.x - tree, 0), {tree, room.size.y}}, volumes, source.font);
    return {std::move(drawing), "Bounding volumes with a ray that enters some and misses others, and their tree"};
}

} // namespace shadowlab::figures
