// SPDX-License-Identifier: MIT
#include "app/report/page/chart_legend.h"

#include <algorithm>
#include <cmath>

#include "app/report/page/chart.h"
#include "app/report/page/log_axis.h"
#include "app/report/page/technique_mark.h"

namespace shadowlab::report {

namespace {

constexpr double kLine = 32;   ///< pixels from a line of text to the next
constexpr double kSample = 40; ///< width of what stands before the words of a legend
constexpr double kMarker = 11; ///< radius, as in the chart
const drawing::TextStyle kText{kChartType, drawing::Anchor::start, false, false, "#000000", false};
const drawing::TextStyle kBold{kChartType, drawing::Anchor::start, true, false, "#000000", false};

const drawing::TextStyle kItalic{kChartType, drawing::Anchor::start, false, true, "#000000", false};

std::string unitOf(const Group& group) { return group.truth == judge::TruthOf::area ? "" : " px"; }

} // namespace

std::vector<std::string> sweepsOf(const Group& group, const std::string& technique) {
    std::vector<std::string> titles;
    for (const Point& point : group.points)
        if (point.key.technique == technique && !point.key.varies.empty() && hasPlace(point) &&
            std::ranges::find(titles, point.key.sweep) == titles.end())
            titles.push_back(point.key.sweep);
    return titles;
}

std::string frontValues(const Group& group, const Point& point) {
    const std::string error =
        isInZeroRow(point) ? "no wrong pixel" : "error " + threeDigits(point.errors.shown()) + unitOf(group);
    return threeDigits(point.costs->frame.median) + " ms, " + error;
}

bool hasPlace(const Point& point) {
    if (!point.costs || !std::isfinite(point.costs->frame.median) || point.costs->frame.median <= 0) return false;
    if (!std::isfinite(point.errors.shown())) return false;
    return point.errors.shown() > 0 || point.errors.wrong() == 0;
}

bool isInZeroRow(const Point& point) { return point.errors.shown() <= 0 || point.errors.isExact(); }

std::vector<std::size_t> frontOf(const Group& group) {
    std::vector<std::size_t> front;
    for (std::size_t i = 0; i < group.points.size(); ++i)
        if (group.points[i].onFront && hasPlace(group.points[i])) front.push_back(i);
    std::ranges::stable_sort(front, [&](std::size_t a, std::size_t b) {
        const Point &left = group.points[a], &right = group.points[b];
        const double costLeft = left.costs->frame.median, costRight = right.costs->frame.median;
        return costLeft != costRight ? costLeft < costRight : left.errors.shown() > right.errors.shown();
    });
    return front;
}

std::string fitted(const image::Font& font, const std::string& text, double em, double width) {
    if (font.measure(text, em).width <= width) return text;
    std::string part = text;
    while (!part.empty() && font.measure(part + "…", em).width > width) {
        // A letter may be several bytes: all but the first of them begin with the bits 10 (UTF-8).
        while (!part.empty() && (static_cast<unsigned char>(part.back()) & 0xc0) == 0x80)
            part.pop_back();
        if (!part.empty()) part.pop_back();
    }
    return part + "…";
}

double drawLegend(drawing::Drawing& drawing, const Group& group, const image::Font& font, dvec2 corner, double width) {
    double y = corner.y + kChartType;
    const auto write = [&](const std::string& text) {
        drawing.text({corner.x + kSample, y}, fitted(font, text, kChartType, width - kSample), kText);
        y += kLine;
    };
    const auto middle = [&] { return dvec2(corner.x + 0.4 * kSample, y - 0.35 * kChartType); };
    const std::map<std::string, TechniqueMark> marks = marksOf(group);
    std::vector<std::string> told; // in the order of the points
    for (const Point& point : group.points) {
        const std::string& technique = point.key.technique;
        if (std::ranges::find(told, technique) != told.end()) continue;
        told.push_back(technique);
        drawMark(drawing, middle(), marks.at(technique), kMarker, false);
        write(technique);
        for (const std::string& title : sweepsOf(group, technique)) {
            drawing.line(middle() - dvec2(14, 0), middle() + dvec2(14, 0), {"#707070", 1.5, false});
            drawing.text({corner.x + kSample, y}, fitted(font, title, kChartType, width - kSample), kItalic);
            y += kLine;
        }
    }
    y += 0.5 * kLine;
    const auto sample = [&](const drawing::Stroke& stroke, const std::string& text) {
        drawing.line(middle() - dvec2(14, 0), middle() + dvec2(14, 0), stroke);
        write(text);
    };
    sample({"#000000", 3, false}, "Pareto front, with");
    write("numbers: see below");
    sample({"#707070", 1.5, false}, "points of one sweep");
    const double ends[] = {-14, 14};
    for (const double end : ends)
        drawing.line(middle() + dvec2(end, -6), middle() + dvec2(end, 6), {"#1a1a1a", 2, false});
    sample({"#1a1a1a", 2, false}, "95 % confidence");
    write("interval of the median");
    if (std::ranges::any_of(group.points, [](const Point& point) { return point.errors.served < 1; })) {
        drawMark(drawing, middle(), {"#1a1a1a", 0}, kMarker, true);
        write("white inside: serves");
        write("a part of the pixels");
    }
    return y;
}

double drawFrontKey(drawing::Drawing& drawing, const Group& group, const image::Font& font, dvec2 place, double width) {
    const std::vector<std::size_t> front = frontOf(group);
    if (front.empty()) return place.y;
    drawing.text(place, "Pareto front: nothing else is both as cheap and as exact", kBold);
    int number = 0;
    for (const std::size_t index : front) {
        const Point& point = group.points[index];
        const std::string cost = frontValues(group, point);
        place.y += kLine;
        drawing.text({place.x + 30, place.y}, std::to_string(++number),
                     {kChartType, drawing::Anchor::end, true, false, "#000000", false});
        const double costWidth = font.measure(cost, kChartType).width;
        drawing.text({place.x + 48, place.y}, fitted(font, point.key.name(), kChartType, width - costWidth - 78),
                     kText);
        drawing.text({place.x + width, place.y}, cost,
                     {kChartType, drawing::Anchor::end, false, false, "#000000", false});
    }
    return place.y;
}

} // namespace shadowlab::report
