// SPDX-License-Identifier: MIT
#include <algorithm>

#include "app/figures/panels.h"
#include "app/figures/rays/tree_layout.h"

namespace shadowlab::figures {

namespace {

constexpr double kLevel = 142, kNodeHeight = 70, kTop = 92, kBottom = 48; ///< pixels

} // namespace

double treeHeight(const Probe& probe, const ShownTree& shown) {
    return kTop + kLevel * (TreeLayout(probe, shown).levels() - 1) + kNodeHeight + kBottom;
}

void drawTree(drawing::Drawing& drawing, const drawing::Box& area, const Probe& probe, const ShownTree& shown, const image::Font& font) {
    const TreeLayout layout(probe, shown);
    const double column = area.size.x / std::max(1, layout.ends());
    const double width = std::min(330.0, column - 14);
    const auto centre = [&](int ray) {
        const dvec2 place = layout.place(ray);
        return area.corner + dvec2((place.x + 0.5) * column, kTop + kLevel * place.y + kNodeHeight / 2);
    };
    drawing.text(area.corner + dvec2(0, kHeading), "Ray-tracing tree", {.size = kHeading, .isBold = true});
    // The edges first: nodes cover their ends.
    for (const int ray : shown.rays) {
        const Probe::Node& node = probe.tree[static_cast<std::size_t>(ray)];
        const dvec2 to = centre(ray);
        const dvec2 from = node.parent < 0 ? to - dvec2(0, kTop) : centre(node.parent);
        drawing.line(from, to, strokeOf(node.role));
    }
    for (const int ray : shown.rays) {
        const Probe::Node& node = probe.tree[static_cast<std::size_t>(ray)];
        const dvec2 at = centre(ray), corner = at - 0.5 * dvec2(width, kNodeHeight);
        const bool isLeaf = node.surface.empty();
        drawing.rectangle(corner, {width, kNodeHeight}, isLeaf ? "#f2f2f2" : "#ffffff",
                          {isLeaf ? "#8c8c8c" : "#1a1a1a", isLeaf ? 1.5 : 2.5, false}, isLeaf ? 4 : 16);
        const bool hasIntensity = !node.end.starts_with("none");
        drawing.text(at - dvec2(0, hasIntensity ? 6 : -8),
                     shortened(font, (node.surface.empty() ? endName(node) : node.surface + "  " + node.object),
                               kText * 0.92, width - 16),
                     {.size = kText * 0.92, .anchor = drawing::Anchor::middle, .isBold = !isLeaf});
        if (hasIntensity)
            drawing.text(at + dvec2(0, 24),
                         shortened(font, "I = " + colorNumbers(node.intensity), kText * 0.85, width - 8),
                         {.size = kText * 0.85, .anchor = drawing::Anchor::middle});
    }
    // Signs just over the nodes they lead to, where edges are farthest apart.
    for (const int ray : shown.rays) {
        const Probe::Node& node = probe.tree[static_cast<std::size_t>(ray)];
        const dvec2 foot = centre(ray) - dvec2(0, kNodeHeight / 2 + 10);
        const std::string sign = node.parent < 0                       ? "pixel ray"
                                 : node.segment < 0 && node.share == 0 ? node.sign
                                                                       : node.sign + "   " + percent(node.share);
        const dvec2 way = node.parent < 0 ? dvec2(0, 1) : centre(ray) - centre(node.parent);
        // Outside of a leaning edge; beside an upright one. Where columns are narrow, over the edge itself.
        const double half = drawing::textSize(font, sign, kText * 0.9).x / 2;
        const double aside = std::min(half + 12, column / 2 - 6 - half);
        drawing.text(foot + dvec2(way.x >= 0 ? aside : -aside, 0), sign,
                     {.size = kText * 0.9, .anchor = drawing::Anchor::middle});
    }
    std::string note = "percent: share of the pixel that the ray carries; I = red, green, blue, added up from below";
    if (shown.leftOut > 0)
        note += "; left out: " + std::to_string(shown.leftOut) + (shown.leftOut == 1 ? " ray" : " rays of at most") +
                (shown.leftOut == 1 ? " of " : " ") + percent(shown.largestLeftOut) +
                (shown.leftOut == 1 ? "" : " each");
    drawing.text(area.corner + dvec2(0, area.size.y - 6), note, {.size = kText * 0.85, .color = "#4d4d4d"});
}

} // namespace shadowlab::figures
