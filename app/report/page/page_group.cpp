// SPDX-License-Identifier: MIT
#include "app/report/page/page_group.h"

#include <array>
#include <cmath>
#include <cstdio>

#include "app/drawing/markup.h"
#include "app/report/page/chart.h"
#include "app/report/page/log_axis.h"
#include "app/report/page/phone_legend.h"
#include "app/report/page/technique_mark.h"

namespace shadowlab::report {

namespace {

constexpr std::array<std::uint8_t, 8> kSignature{0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'};
constexpr std::size_t kSizeAt = 16; ///< the header's width and height, four bytes each (PNG, ISO/IEC 15948)

/// {0, 0}: no PNG file.
glm::uvec2 sizeOf(const std::vector<std::uint8_t>& png) {
    if (png.size() < kSizeAt + 8 || !std::equal(kSignature.begin(), kSignature.end(), png.begin())) return {0, 0};
    glm::uvec2 size(0);
    for (std::size_t i = 0; i < 4; ++i) {
        size.x = size.x << 8 | png[kSizeAt + i];
        size.y = size.y << 8 | png[kSizeAt + 4 + i];
    }
    return size;
}

using drawing::escapedMarkup;

constexpr int kColumns = 14; ///< of the table of points

/// A cell with a number, and the number itself for sorting; empty there: there is none, and it is sorted last.
std::string cell(const std::optional<double>& value, const std::string& text) {
    const bool isNumber = value && std::isfinite(*value);
    return "<td data-v=\"" + (isNumber ? threeDigits(*value) : "") + "\">" + (isNumber ? text : "–") + "</td>";
}
std::string cell(const std::optional<double>& value) { return cell(value, value ? threeDigits(*value) : ""); }

std::string settingsOf(const PointKey& key) {
    std::string text;
    for (const std::string& setting : key.settings)
        text += (text.empty() ? "" : " ") + setting;
    return text.empty() ? "defaults" : text;
}

std::string ms(double value) { return threeDigits(value) + " ms"; }

std::string chartMarkup(const Report& report, std::size_t number) {
    const Group& group = report.groups[number];
    const Chart chart = chartOf(group, report.size);
    std::string svg = chart.drawing.document(chartTitle(group));
    svg = svg.substr(svg.find("<svg"));
    svg.resize(svg.rfind("</svg>"));
    for (const Chart::Spot& spot : chart.spots) {
        const Point& point = group.points[spot.point];
        const std::string x = std::to_string(std::lround(spot.place.x)), y = std::to_string(std::lround(spot.place.y));
        svg += "<a class=\"spot\" href=\"#" + pointId(number, spot.point) + "\" tabindex=\"-1\"><title>" +
               escapedMarkup(point.key.name()) + ": " + ms(point.costs->frame.median) + ", error " +
               threeDigits(point.errors.shown()) + "</title><circle cx=\"" + x + "\" cy=\"" + y +
               "\" r=\"14\" fill=\"#ffffff\" fill-opacity=\"0\"/></a>\n";
    }
    // In shares of the plot, by which a phone cuts it out of the sheet.
    const dvec2 sheet = chart.drawing.size();
    std::array<char, 160> place{};
    std::snprintf(place.data(), place.size(), "--wide: %.5f; --left: %.5f; --top: %.5f; --shape: %.5f", sheet.x / chart.plotSize.x,
                  chart.plotCorner.x / chart.plotSize.x, chart.plotCorner.y / chart.plotSize.y, chart.plotSize.x / chart.plotSize.y);
    return "<figure class=\"chart\">\n<div class=\"plot\" style=\"" + std::string(place.data()) + "\">" + svg + "</svg></div>\n" +
           phoneLegend(group) +
           "<figcaption>The nearer to the lower left corner, the better. A marker leads to its row in the "
           "table "
           "below.</figcaption>\n</figure>\n";
}

/// What a table of points begins with.
std::string heads(const Group& group) {
    const std::string error = group.truth == judge::TruthOf::area ? "error: RMSE" : "error [px]";
    std::string html = "<thead><tr><th scope=\"col\" class=\"text name\">point</th>";
    for (const std::string& head :
         {std::string("frame [ms]"), std::string("95 % interval, by width"), std::string("95 of 100 below"),
          std::string("prepare [ms]"), std::string("draw [ms]"), std::string("shadows alone [ms]"),
          std::string("at rest [ms]"), error, std::string("wrong pixels"), std::string("served [%]"),
          std::string("OpenGL [MB]"), std::string("process [MB]"), std::string("Pareto front")})
        html += "<th scope=\"col\">" + head + "</th>";
    return html + "</tr></thead>\n";
}

std::string timeCells(const std::optional<Costs>& costs) {
    if (!costs) {
        std::string cells;
        for (int i = 0; i < 7; ++i)
            cells += cell({});
        return cells;
    }
    const Spread& frame = costs->frame;
    return cell(frame.median) +
           cell(frame.upper - frame.lower, threeDigits(frame.lower) + " to " + threeDigits(frame.upper)) +
           cell(frame.p95) + cell(costs->prepare.median) + cell(costs->draw.median) + cell(costs->shadow.median) +
           cell(costs->atRest.median);
}

std::string definition(const std::string& word, const std::string& meaning) {
    return "<br><b>" + word + ":</b> " + meaning + "\n";
}

/// What does not fit into the row: where the time goes, what was counted, and how it is wrong.
std::string facts(const Point& point) {
    const Errors& e = point.errors;
    std::string html = "<p>";
    html += "<b>pixels:</b> " + std::to_string(e.pixels) + " (" + std::to_string(e.lit) + " lit, " +
            std::to_string(e.shadowed) + " in shadow, " + std::to_string(e.turnedAway) + " turned away, " +
            std::to_string(e.ties) + " ties); " + std::to_string(e.falseLit) + " false lit, " +
            std::to_string(e.falseShadow) + " false shadow, of these " + std::to_string(e.core) +
            " core errors; RMSE " + threeDigits(e.rmse) + (e.converged ? "" : "; not converged") + "\n";
    if (point.costs) {
        const Costs& c = *point.costs;
        html += definition("frames", std::to_string(c.frames) + " counted; encoding the picture " +
                                         ms(c.encode.median) + ", first frame " + ms(c.firstMs));
        std::string passes;
        for (const Costs::Pass& pass : c.passes)
            passes += (passes.empty() ? "" : ", ") + escapedMarkup(pass.id) + " " + ms(pass.ms);
        if (!passes.empty()) html += definition("passes, timed one by one", passes);
    } else {
        html += definition("times", "not measured yet");
    }
    std::string counters;
    for (const Errors::Counter& counter : e.counters)
        counters += (counters.empty() ? "" : ", ") + escapedMarkup(counter.id) + " " + threeDigits(counter.built) +
                    (counter.of > 0 ? " of " + threeDigits(counter.of) : "") +
                    (counter.unit.empty() ? "" : " " + escapedMarkup(counter.unit));
    if (!counters.empty()) html += definition("counted", counters);
    return html + "</p>\n";
}

std::string pointRows(const Group& group, std::size_t number, std::size_t index, const TechniqueMark& mark,
                      Pictures& pictures) {
    const Point& point = group.points[index];
    const Errors& e = point.errors;
    const std::string id = pointId(number, index), name = point.key.name();
    std::string html = "<tbody id=\"" + id + "\"" + (point.onFront ? " class=\"best\"" : "") +
                       "><tr><th scope=\"row\" class=\"text name\">" + markOf(mark, e.served < 1) +
                       escapedMarkup(point.key.technique) + "<br>" + escapedMarkup(settingsOf(point.key)) + "</th>";
    html += timeCells(point.costs);
    const bool hasError = e.truth == judge::TruthOf::area || e.edgeErrorPx;
    html += cell(hasError ? std::optional(e.shown()) : std::nullopt) + "<td data-v=\"" + std::to_string(e.wrong()) +
            "\">" + std::to_string(e.wrong()) + "</td>" + cell(100 * e.served) + cell(e.glMegabytes) +
            cell(point.costs ? std::optional(point.costs->residentMegabytes) : std::nullopt) + "<td>" +
            (point.isYardstick ? "yardstick"
             : point.onFront   ? "on it"
                               : "no") +
            "</td></tr>\n";
    html += "<tr class=\"details\" id=\"" + id + "-more\"><td colspan=\"" + std::to_string(kColumns) +
            "\"><div class=\"shown\"><div class=\"command\"><code>" + escapedMarkup(point.command) +
            "</code></div>\n<div class=\"pair\"><figure>" + pictures.shown(point.picturePng, name + ": the picture") +
            "<figcaption>What it draws</figcaption></figure>\n<figure>" +
            pictures.shown(point.errorPng, name + ": where it is wrong") +
            "<figcaption>Where it is wrong: orange is lit and should not be, blue is dark and should not be, pink is a "
            "surface where there is none, darkest "
            "grey are "
            "ties</figcaption></figure></div>\n";
    return html + facts(point) + "</div></td></tr></tbody>\n";
}

std::string growthTable(const Group& group) {
    if (group.growth.empty()) return "";
    std::string html =
        "<div class=\"growth\">\n<h3>How it grows</h3>\n<p>Time ~ value<sup>a</sup> and error ~ value<sup>b</sup>, by "
        "least squares of "
        "the logarithms.</p>\n<div class=\"wide\"><table class=\"sortable\"><thead><tr><th scope=\"col\" "
        "class=\"text\">technique</th><th scope=\"col\" class=\"text\">sweep</th><th scope=\"col\" "
        "class=\"text\">what changes</th><th scope=\"col\">from</th><th scope=\"col\">to</th><th "
        "scope=\"col\">a, of time</th><th scope=\"col\">time when doubled</th><th scope=\"col\">b, of "
        "error</th><th scope=\"col\">error when doubled</th></tr></thead>\n";
    for (const Growth& growth : group.growth) {
        const std::optional<double>& b = growth.errorPower;
        const double time = std::exp2(growth.costPower), error = b ? std::exp2(*b) : 0;
        html += "<tbody><tr><th scope=\"row\" class=\"text\">" + escapedMarkup(growth.technique) +
                "</th><td class=\"text\">" + escapedMarkup(growth.sweep) + "</td><td class=\"text\">" +
                escapedMarkup(growth.varies) + "</td>" + cell(growth.from) + cell(growth.to) + cell(growth.costPower) +
                cell(time, "× " + threeDigits(time)) + cell(b) +
                cell(b ? std::optional(error) : std::nullopt, "× " + threeDigits(error)) + "</tr></tbody>\n";
    }
    return html + "</table></div>\n</div>\n";
}

} // namespace

std::string Pictures::shown(const std::vector<std::uint8_t>& png, const std::string& alt) {
    const glm::uvec2 size = sizeOf(png);
    if (size.x == 0 || size.y == 0) return "<p>No picture was kept.</p>";
    const std::string width = std::to_string(size.x), height = std::to_string(size.y);
    const auto [place, isNew] = numbers_.emplace(png, numbers_.size() + 1);
    const std::string id = "picture" + std::to_string(place->second);
    if (isNew)
        definitions_ += "<image id=\"" + id + "\" width=\"" + width + "\" height=\"" + height +
                        "\" href=\"data:image/png;base64," + drawing::base64(png) + "\"/>\n";
    return "<svg viewBox=\"0 0 " + width + " " + height + "\" role=\"img\" aria-label=\"" +
           drawing::escapedMarkup(alt) + "\"><use href=\"#" + id + "\"/></svg>";
}

std::string Pictures::definitions() const {
    return "<svg class=\"store\" aria-hidden=\"true\"><defs>\n" + definitions_ + "</defs></svg>\n";
}

std::string groupId(std::size_t group) { return "g" + std::to_string(group + 1); }
std::string pointId(std::size_t group, std::size_t point) { return groupId(group) + "p" + std::to_string(point + 1); }

std::string groupSection(const Report& report, std::size_t number, Pictures& pictures) {
    const Group& group = report.groups[number];
    std::string html = "<section>\n<h2 id=\"" + groupId(number) + "\">" + escapedMarkup(group.scene) + ", light " +
                       escapedMarkup(group.light) + (group.truth == judge::TruthOf::area ? ", its whole area" : "") +
                       "</h2>\n";
    if (group.points.empty()) return html + "<p>No technique has been measured here.</p>\n</section>\n";
    html += chartMarkup(report, number);
    html += "<div class=\"wide points-frame\"><table class=\"points sortable\"><caption>All points: medians of frames "
            "in which the "
            "light "
            "moves by one degree. Bold: on the Pareto front.</caption>\n" +
            heads(group);
    const std::map<std::string, TechniqueMark> marks = marksOf(group);
    for (std::size_t i = 0; i < group.points.size(); ++i)
        html += pointRows(group, number, i, marks.at(group.points[i].key.technique), pictures);
    return html + "</table></div>\n" + growthTable(group) + "</section>\n";
}

} // namespace shadowlab::report
