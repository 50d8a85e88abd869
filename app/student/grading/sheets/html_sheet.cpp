// SPDX-License-Identifier: MIT
#include "app/drawing/markup.h"
#include "app/student/grading/likely_blanks.h"
#include "app/student/grading/sheets/html_parts.h"
#include "app/student/grading/sheets/sheets.h"

namespace shadowlab::student {

namespace {

constexpr std::string_view kStyle =
    "body{font:16px/1.5 sans-serif;max-width:64em;margin:2em auto;padding:0 1em;color:#1b1b1f;background:#fff}"
    "table{border-collapse:collapse;width:100%}th,td{text-align:left;padding:.3em .6em;border-bottom:1px solid #d0d0d4}"
    "td.n{text-align:right;font-variant-numeric:tabular-nums}.no{color:#a1260d;font-weight:bold}.yes{color:#1a6b2f}"
    "section{margin-top:2em;border-top:2px solid #d0d0d4}";

} // namespace

std::string htmlSheet(const Sheet& sheet, const std::vector<Blank>& blanks, const std::optional<SearchReport>& search) {
    const std::string title = std::string(sheet.family->title) + ": " + sheet.candidate.technique;
    // No script, and nothing from elsewhere, whatever stands in a plug-in's messages.
    std::string html = "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">\n"
                       "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; style-src 'unsafe-inline'; img-src data:\">\n<title>" +
                       drawing::escapedMarkup(title) + "</title>\n<style>" + std::string(kStyle) + "</style></head>\n<body>\n<h1>" + drawing::escapedMarkup(title) + "</h1>\n<p>" +
                       drawing::escapedMarkup(sheet.candidate.plugin.filename().string()) + ", <strong>" + std::to_string(sheet.points()) + " of " +
                       std::to_string(sheet.mostPoints()) + " points</strong></p>\n";
    if (const std::string likely = likelyText(sheet, blanks); !likely.empty())
        html += "<p>" + drawing::escapedMarkup(likely) + "</p>\n";
    html += "<table><thead><tr><th>case</th><th>idea</th>" + std::string(blanks.empty() ? "" : "<th>tests blanks</th>") + "<th>wrong pixels</th><th>limit</th><th>points</th></tr></thead><tbody>\n";
    for (const CaseResult& result : sheet.results) {
        const std::string id(result.which->id);
        html += "<tr><td>" + (result.isRight() ? drawing::escapedMarkup(id) : "<a href=\"#" + id + "\">" + drawing::escapedMarkup(id) + "</a>") + "</td><td>" +
                drawing::escapedMarkup(result.which->idea) + "</td>" + (blanks.empty() ? "" : "<td>" + drawing::escapedMarkup(result.which->blanks) + "</td>") + "<td class=\"n\">" +
                (result.wrong ? std::to_string(*result.wrong) : "no picture") + "</td><td class=\"n\">" + std::to_string(result.which->limit) +
                "</td><td class=\"n " + (result.isRight() ? "yes" : "no") + "\">" + std::to_string(result.points()) + "/" +
                std::to_string(result.which->points) + "</td></tr>\n";
    }
    html += "</tbody></table>\n";
    for (const CaseResult& result : sheet.results)
        if (!result.isRight())
            html += "<section id=\"" + std::string(result.which->id) + "\"><h2>" + drawing::escapedMarkup(result.which->id) + ": " +
                    drawing::escapedMarkup(result.which->idea) + "</h2>" + caseHtml(result, *sheet.family, blanks) + "</section>\n";
    if (search) html += "<section id=\"search\"><h2>Search for a failing scene</h2>" + searchHtml(*search, blanks) + "</section>\n";
    return html + "</body></html>\n";
}

} // namespace shadowlab::student
