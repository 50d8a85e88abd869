// SPDX-License-Identifier: MIT
#include "app/report/page/phone_legend.h"

#include <algorithm>
#include <array>

#include "app/drawing/markup.h"
#include "app/report/page/chart_legend.h"
#include "app/report/page/log_axis.h"

namespace shadowlab::report {

namespace {

using drawing::escapedMarkup;

/// A small drawing before a line of text.
template <typename Draw> std::string sample(Draw&& draw) {
    drawing::Drawing drawing({24, 24});
    draw(drawing);
    const std::string document = drawing.document("");
    // What surrounds a drawing is for files: its letters, its paper, its name.
    const std::size_t paper = document.find("<rect"), begin = document.find('\n', paper) + 1;
    return "<svg class=\"mark\" viewBox=\"0 0 24 24\" aria-hidden=\"true\">" + document.substr(begin, document.rfind("</svg>") - begin) +
           "</svg>";
}

std::string lineSample(const drawing::Stroke& stroke) {
    return sample([&](drawing::Drawing& drawing) { drawing.line({0, 12}, {24, 12}, stroke); });
}

std::string item(const std::string& content) { return "<li>" + content + "</li>\n"; }

} // namespace

std::string markOf(const TechniqueMark& mark, bool isOpen) {
    return sample([&](drawing::Drawing& drawing) { drawMark(drawing, dvec2(12), mark, 10, isOpen); });
}

std::string phoneLegend(const Group& group) {
    std::string html = "<div class=\"phone-legend\">\n<ul>\n";
    const std::map<std::string, TechniqueMark> marks = marksOf(group);
    std::vector<std::string> told; // in the order of the points
    bool hasSweeps = false;
    for (const Point& point : group.points) {
        const std::string& technique = point.key.technique;
        if (std::ranges::find(told, technique) != told.end()) continue;
        told.push_back(technique);
        std::string sweeps;
        for (const std::string& title : sweepsOf(group, technique))
            sweeps += (sweeps.empty() ? ": <em>" : ", <em>") + escapedMarkup(title) + "</em>";
        hasSweeps = hasSweeps || !sweeps.empty();
        html += item(markOf(marks.at(technique), false) + escapedMarkup(technique) + sweeps);
    }
    if (hasSweeps) html += item(lineSample({"#707070", 2, false}) + "a thin line joins the points of one sweep");
    html += item(sample([](drawing::Drawing& drawing) {
                     drawing.segments(std::array{dvec2(2, 12), dvec2(22, 12), dvec2(2, 6), dvec2(2, 18), dvec2(22, 6), dvec2(22, 18)},
                                      {"#1a1a1a", 2, false});
                 }) +
                 "95 % confidence interval of the median");
    if (std::ranges::any_of(group.points, [](const Point& point) { return point.errors.served < 1; }))
        html += item(markOf({"#1a1a1a", 0}, true) + "white inside: serves a part of the pixels");
    html += "</ul>\n";
    const std::vector<std::size_t> front = frontOf(group);
    if (!front.empty()) {
        html += "<p>" + lineSample({"#000000", 3, false}) + "Pareto front: nothing else is both as cheap and as exact</p>\n<ol>\n";
        for (const std::size_t index : front)
            html += item(escapedMarkup(group.points[index].key.name()) + ": " + frontValues(group, group.points[index]));
        html += "</ol>\n";
    }
    const auto missing = std::ranges::count_if(group.points, [](const Point& point) { return !hasPlace(point); });
    if (missing > 0)
        html += "<p>" + std::to_string(missing) + " of " + std::to_string(group.points.size()) +
                " points have no place here: not measured, or no boundary to count by</p>\n";
    return html + "</div>\n";
}

} // namespace shadowlab::report
