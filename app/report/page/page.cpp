// SPDX-License-Identifier: MIT
#include "app/report/page/page.h"

#include "app/drawing/markup.h"
#include "app/report/page/log_axis.h"
#include "app/report/page/page_group.h"
#include "app/report/page/page_style.h"

namespace shadowlab::report {

namespace {

using drawing::escapedMarkup;

struct Comparison {
    bool isWithin = false, isComparison = false;
    std::string words, why;
};

Comparison verdictOf(const ExactAgainstInexact& found) {
    if (!found.exact && !found.inexact) return {false, false, "nothing to compare", "no point has been measured"};
    if (!found.exact) return {false, false, "no exact point", "every technique measured here has wrong pixels"};
    if (!found.inexact) return {true, false, "all exact", "no technique measured here has a wrong pixel"};
    if (found.frameRatio > kMostRatio)
        return {false, true, "more than 2 times", found.why.empty() ? "the reason is not known" : found.why};
    return {true, true, "within 2 times", found.why};
}

std::string pointCell(const Report& report, std::size_t group, const std::optional<std::size_t>& index) {
    const std::vector<Point>& points = report.groups[group].points;
    if (!index || *index >= points.size()) return "<td class=\"text\">none</td>";
    const Point& point = points[*index];
    return "<td class=\"text\"><a href=\"#" + pointId(group, *index) + "\">" + escapedMarkup(point.key.name()) +
           "</a>" + (point.costs ? ", " + threeDigits(point.costs->frame.median) + " ms" : "") + "</td>";
}

std::string ratioCell(double ratio) {
    const std::string text = threeDigits(ratio);
    return ratio > 0 ? "<td data-v=\"" + text + "\">" + text + "</td>" : "<td data-v=\"\">–</td>";
}

std::string summary(const Report& report) {
    std::size_t within = 0, compared = 0;
    std::string rows;
    for (std::size_t i = 0; i < report.groups.size(); ++i) {
        const Group& group = report.groups[i];
        const ExactAgainstInexact& found = group.exactness;
        const Comparison verdict = verdictOf(found);
        compared += verdict.isComparison;
        within += verdict.isComparison && verdict.isWithin;
        rows += "<tbody><tr><th scope=\"row\" class=\"text\"><a href=\"#" + groupId(i) + "\">" +
                escapedMarkup(group.scene) + ", light " + escapedMarkup(group.light) + "</a></th><td class=\"text\">" +
                (group.truth == judge::TruthOf::area ? "area" : "centre") + "</td>" +
                pointCell(report, i, found.exact) + pointCell(report, i, found.inexact) + ratioCell(found.frameRatio) +
                ratioCell(found.shadowRatio) + "<td class=\"text verdict\">" + verdict.words +
                "</td><td class=\"text\">" + escapedMarkup(verdict.why) + "</td></tr></tbody>\n";
    }
    return "<h2 class=\"first\" id=\"summary\">What exactness costs</h2>\n<p>In " + std::to_string(within) + " of " +
           std::to_string(compared) +
           " comparisons a frame with exact shadows takes at most 2 times as long as the cheapest one with wrong "
           "pixels. "
           "Where it takes longer, the last column says what takes the time.</p>\n<div class=\"wide\"><table "
           "class=\"sortable\"><thead><tr><th scope=\"col\" class=\"text\">scene and light</th><th scope=\"col\" "
           "class=\"text\">judged by</th><th scope=\"col\" class=\"text\">cheapest exact</th><th scope=\"col\" "
           "class=\"text\">cheapest inexact</th><th scope=\"col\">ratio of frames</th><th scope=\"col\">ratio of "
           "shadows "
           "alone</th><th scope=\"col\" class=\"text\">verdict</th><th scope=\"col\" "
           "class=\"text\">why</th></tr></thead>\n" +
           rows + "</table></div>\n";
}

std::string machines(const Report& report) {
    std::string html = "<h2 id=\"machine\">The machine</h2>\n";
    if (report.machines.empty()) return html + "<p>None is known.</p>\n";
    html += "<div class=\"wide\"><table><thead><tr>";
    for (const char* head : {"processor", "renderer", "OpenGL", "backend", "compiler", "program"})
        html += "<th scope=\"col\" class=\"text\">" + std::string(head) + "</th>";
    for (const char* head : {"cores", "threads", "threads of the rasteriser", "memory [GB]"})
        html += "<th scope=\"col\">" + std::string(head) + "</th>";
    html += "</tr></thead>\n<tbody>\n";
    for (const Machine& machine : report.machines) {
        html += "<tr>";
        for (const std::string& text : {machine.processor, machine.renderer, machine.glVersion, machine.backend,
                                        machine.compiler, machine.program})
            html += "<td class=\"text\">" + escapedMarkup(text) + "</td>";
        for (const int count : {machine.cores, machine.threads, machine.rasterThreads})
            html += "<td>" + std::to_string(count) + "</td>";
        html += "<td>" + threeDigits(machine.memoryGigabytes) + "</td></tr>\n";
    }
    return html + "</tbody></table></div>\n";
}

std::string introduction(const Report& report) {
    return "<h1>Shadows: what they cost, and how wrong they are</h1>\n<p>Pictures of " + std::to_string(report.size.x) +
           " × " + std::to_string(report.size.y) + " pixels" + (report.isQuick ? ", a quick report" : "") + ". " +
           std::to_string(report.rounds) +
           " rounds: in each, all points of a scene take turns, so that a slow moment of the machine hits all alike. "
           "Times are "
           "medians, with the interval in which the median lies with 95 % confidence. <em>Shadows alone</em> is a "
           "frame less "
           "one without shadows in the same round; <em>at rest</em> is a frame in which nothing has "
           "moved.</p>\n<p>Errors are "
           "held against exact rays. Judged by the centre: wrong pixels divided by the length of the true shadow "
           "boundary, "
           "both in pixels. Judged by the area: RMSE of visibility. A point is on the <em>Pareto front</em> where no "
           "other is "
           "both cheaper and less wrong; <em>unshadowed</em>, the yardstick, casts no shadow and is never on "
           "it.</p>\n<p>Choose a point's name for its picture, its error map, and the command "
           "that "
           "measures it again; choose the head of a column to sort by it.</p>\n";
}

} // namespace

std::string htmlPage(const Report& report) {
    Pictures pictures;
    std::string groups;
    for (std::size_t i = 0; i < report.groups.size(); ++i)
        groups += groupSection(report, i, pictures);
    return "<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
           "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
           "<title>Shadows: cost and error</title>\n<style>" +
           std::string(kPageStyle) + "</style>\n</head>\n<body>\n<main>\n" + introduction(report) + summary(report) +
           groups + machines(report) + "</main>\n<p class=\"told\" id=\"told\" role=\"status\"></p>\n" +
           pictures.definitions() + "<script>" + std::string(kCardsScript) + std::string(kPageScript) +
           "</script>\n</body>\n</html>\n";
}

} // namespace shadowlab::report
