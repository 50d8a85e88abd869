// The lecture's three figures of a pixel's rays, each alone: their paths, their tree, the vectors at the first surface.
// SPDX-License-Identifier: MIT
#include <algorithm>

#include "app/figures/figure_drawers.h"
#include "app/figures/figure_parts.h"
#include "app/figures/panels.h"
#include "app/figures/rays/tree_layout.h"

namespace shadowlab::figures {

namespace {

constexpr double kLeastColumn = 200; ///< pixels: three numbers, or a name
constexpr double kFigureNodeHeight = 100, kMostPitch = 190, kLeastPitch = 156, kFigureTop = 100;

/// As many rays as can be distinguished in a drawing of that size. Drawings of one size show the same rays, so that a figure of
/// paths fits the figure of its tree.
ShownTree shownIn(const FigureSource& source) {
    const drawing::Box room = roomOf(source);
    const int ends = std::clamp(static_cast<int>(room.size.x / kLeastColumn), 1, kMostEnds);
    const double levels = (room.size.y - kFigureTop - kFigureNodeHeight - 2.6 * kText) / kLeastPitch + 1;
    return shownTree(source.probe, ends, std::clamp(static_cast<int>(levels), 1, kMostLevels));
}

void drawNode(drawing::Drawing& drawing, const Probe::Node& node, dvec2 at, double width, const image::Font& font) {
    const bool isLeaf = node.surface.empty();
    drawing.rectangle(at - 0.5 * dvec2(width, kFigureNodeHeight), {width, kFigureNodeHeight},
                      isLeaf ? "#f2f2f2" : "#ffffff", {isLeaf ? "#8c8c8c" : "#1a1a1a", isLeaf ? 1.5 : 3.0, false},
                      isLeaf ? 4 : 20);
    std::vector<std::pair<std::string, bool>> lines;
    if (!isLeaf) lines.emplace_back(node.surface, true);
    lines.emplace_back(shortened(font, isLeaf ? endName(node) : node.object, kText, width - 12), false);
    if (!node.end.starts_with("none")) lines.emplace_back(colorNumbers(node.intensity), false);
    const double row = 1.22 * kText;
    double foot = at.y - 0.5 * row * static_cast<double>(lines.size()) + 0.9 * kText;
    for (const auto& [text, isBold] : lines) {
        drawing.text({at.x, foot}, text, {.size = kText, .anchor = drawing::Anchor::middle, .isBold = isBold, .hasRim = false});
        foot += row;
    }
}

} // namespace

Diagram drawPathsFigure(const FigureSource& source) {
    treeOf(source);
    drawing::Drawing drawing(source.size);
    drawPaths(drawing, roomOf(source), source.probe, shownIn(source), source.scene, source.font);
    return {std::move(drawing), "Paths of pixel rays, in the plane of incidence at the first surface"};
}

Diagram drawVectorsFigure(const FigureSource& source) {
    treeOf(source);
    drawing::Drawing drawing(source.size);
    drawVectors(drawing, roomOf(source), source.probe, source.font);
    return {std::move(drawing), "The vectors u, V, N, R, T, L and H at the first surface"};
}

Diagram drawTreeFigure(const FigureSource& source) {
    const std::vector<Probe::Node>& tree = treeOf(source);
    const ShownTree shown = shownIn(source);
    const TreeLayout layout(source.probe, shown);
    drawing::Drawing drawing(source.size);
    std::string foot = "Percent: share of the pixel that a ray carries. Numbers: I, red, green, blue.";
    if (shown.leftOut > 0)
        foot += " Left out: " + counted(static_cast<std::size_t>(shown.leftOut), "ray of ", "rays of at most ") +
                percent(shown.largestLeftOut) + ".";
    const drawing::Box room = writeFoot(drawing, roomOf(source), foot, source.font);
    drawing.text(room.corner + dvec2(0, kHeading), "Ray-tracing tree", {.size = kHeading, .isBold = true});

    const double column = room.size.x / std::max(1, layout.ends()), width = std::min(320.0, column - 12);
    const double free = room.size.y - kFigureTop - kFigureNodeHeight;
    const double pitch = std::min(kMostPitch, free / std::max(1, layout.levels() - 1));
    // A flat tree stands in the middle of its room.
    const double top = kFigureTop + 0.5 * std::max(0.0, free - pitch * (layout.levels() - 1));
    const auto centre = [&](int ray) {
        const dvec2 place = layout.place(ray);
        return room.corner + dvec2((place.x + 0.5) * column, top + kFigureNodeHeight / 2 + pitch * place.y);
    };
    const auto node = [&](int ray) -> const Probe::Node& { return tree[static_cast<std::size_t>(ray)]; };
    for (const int ray : shown.rays) {
        const dvec2 to = centre(ray);
        drawing.line(node(ray).parent < 0 ? to - dvec2(0, kFigureNodeHeight / 2 + 44) : centre(node(ray).parent), to,
                     strokeOf(node(ray).role));
    }
    for (const int ray : shown.rays)
        drawNode(drawing, node(ray), centre(ray), width, source.font);
    // Signs stand just over the nodes that they lead to, on the outer side of the edge.
    for (const int ray : shown.rays) {
        const bool isRoot = node(ray).parent < 0;
        const std::string sign = isRoot ? "pixel ray"
                                 : node(ray).segment < 0 && node(ray).share == 0
                                     ? node(ray).sign
                                     : node(ray).sign + "  " + percent(node(ray).share);
        const double half = 0.5 * drawing::textSize(source.font, sign, kText).x;
        const double lean = isRoot ? 1 : centre(ray).x - centre(node(ray).parent).x;
        const double aside = isRoot ? half + 14 : std::min(half + 14, column / 2 - 4 - half);
        drawing.text(centre(ray) + dvec2(lean >= 0 ? aside : -aside, -kFigureNodeHeight / 2 - 10), sign,
                     {.size = kText, .anchor = drawing::Anchor::middle, .isBold = true});
    }
    return {std::move(drawing), "The ray-tracing tree: surfaces, and the reflection and refraction rays between them"};
}

} // namespace shadowlab::figures
