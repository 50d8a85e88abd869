// SPDX-License-Identifier: MIT
#include "app/hard/page.h"

#include "app/drawing/markup.h"
#include "app/hard/tables.h"
#include "app/report/csv.h"
#include "app/report/page/page_style.h"

namespace shadowlab::hard {

using report::joined;
using report::numberText;

namespace {

using drawing::escapedMarkup;

std::string linkedNumber(double value, const Pictures& pictures, const std::string& about, const std::string& facts) {
    return "<td>" + pictureLink(pictures, numberText(value), about, facts) + "</td>";
}

std::string rowsOf(const CaseResult& result, const Row& row) {
    std::string html;
    const std::string title = titleOf(result, row), about = result.id + ", " + row.technique;
    for (const Measured& m : row.measured) {
        const std::string facts = m.quantity + " " + m.bound + ": ";
        html += "<tr>" + tableCell(result.id, "text") + tableCell(title, "text") + tableCell(row.technique, "text") +
                tableCell(joined(row.settings), "text") + tableCell(m.quantity + " " + m.bound, "text") +
                linkedNumber(m.value, row.right, about, facts + numberText(m.value) + " " + m.unit);
        html += m.naive && row.naive
                    ? linkedNumber(*m.naive, *row.naive, about + ", careless: " + joined(row.naiveSettings),
                                   facts + numberText(*m.naive) + " " + m.unit) +
                          tableCell(joined(row.naiveSettings), "text")
                    : tableCell("") + tableCell("");
        html += tableCell(std::string(toText(row.outcome)), row.outcome == Outcome::right ? "text" : "text bad") +
                tableCell(caughtText(row), row.caught.value_or(true) ? "text" : "text bad") + "</tr>\n";
    }
    return html;
}

std::string heads(std::initializer_list<const char*> words) {
    std::string html = "<thead><tr>";
    for (const char* word : words)
        html += "<th scope=\"col\" class=\"text\">" + std::string(word) + "</th>";
    return html + "</tr></thead>\n";
}

std::string checksTable(const std::vector<CaseResult>& results) {
    std::string rows;
    for (const CaseResult& result : results)
        for (const Row& row : result.rows)
            rows += rowsOf(result, row);
    return "<h2 id=\"checks\">The checks</h2>\n<p>What a technique has to make of a case, and what its careless "
           "version "
           "makes of it. A number opens the picture.</p>\n<div class=\"wide\"><table>\n" +
           heads({"case", "what it is", "technique", "settings", "has to be", "is", "careless", "by", "verdict",
                  "careless version"}) +
           "<tbody>\n" + rows + "</tbody></table></div>\n";
}

std::string testsTable(const std::vector<CaseResult>& results) {
    std::string rows;
    for (const CaseResult& result : results)
        if (result.rows.empty())
            rows += "<tr>" + tableCell(result.id, "text") + tableCell(result.title, "text") +
                    tableCell(result.why, "text") + tableCell(joined(result.tests), "text tests") + "</tr>\n";
    return "<h2 id=\"tests\">Held by tests alone</h2>\n<div class=\"wide\"><table>\n" +
           heads({"case", "what it is", "why", "tests"}) + "<tbody>\n" + rows + "</tbody></table></div>\n";
}

std::string introduction(const std::vector<CaseResult>& results, const std::string& renderer) {
    int checks = 0, green = 0, careless = 0, caught = 0, exactCells = 0, exactRight = 0;
    for (const CaseResult& result : results) {
        for (const Row& row : result.rows) {
            ++checks;
            green += row.isGreen();
            careless += row.caught.has_value();
            caught += row.caught.value_or(false);
        }
        for (const Cell& cell : result.cells) {
            exactCells += cell.isExact;
            exactRight += cell.isExact && cell.standing != Standing::wrong && cell.standing != Standing::refused;
        }
    }
    const auto of = [](int some, int all) { return std::to_string(some) + " of " + std::to_string(all); };
    return "<h1>Hard cases</h1>\n<p>" + of(green, checks) + " checks are as they have to be; " + of(caught, careless) +
           " careless versions are caught; what is exact by its nature is without a core error in " +
           of(exactRight, exactCells) + " pictures. Drawn by " + escapedMarkup(renderer) + ".</p>\n";
}

} // namespace

std::string tableCell(const std::string& text, const std::string& kind) {
    return "<td" + (kind.empty() ? "" : " class=\"" + kind + "\"") + ">" + escapedMarkup(text) + "</td>";
}

std::string pictureLink(const Pictures& pictures, const std::string& text, const std::string& about,
                        const std::string& facts) {
    if (pictures.name.empty()) return escapedMarkup(text);
    const std::string base = "pictures/" + escapedMarkup(pictures.name);
    return "<a class=\"shot\" href=\"" + base + ".png\" data-errors=\"" + base + "-errors.png\" data-about=\"" +
           escapedMarkup(about) + "\" data-facts=\"" + escapedMarkup(facts) + "\">" + escapedMarkup(text) + "</a>";
}

std::string hardPage(const std::vector<CaseResult>& results, const std::string& renderer) {
    return "<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
           "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n<title>Hard cases</title>\n"
           "<style>" +
           std::string(report::kPageStyle) + std::string(kHardStyle) + "</style>\n</head>\n<body>\n<main>\n" +
           introduction(results, renderer) + matrixTable(results) + checksTable(results) + carelessTable(results) +
           testsTable(results) +
           "</main>\n<dialog id=\"shown\" aria-labelledby=\"about\"><h2 id=\"about\"></h2>\n<p id=\"facts\"></p>\n"
           "<div class=\"pair\"><figure><img id=\"picture\" alt=\"\"><figcaption>What it draws</figcaption></figure>\n"
           "<figure><img id=\"errors\" alt=\"\"><figcaption>Where it is wrong: orange is lit and should not be, blue "
           "is "
           "dark and should not be, pink is a surface where there is none, darkest grey are ties</figcaption></figure>"
           "</div>\n<form method=\"dialog\"><button>Close</button></form></dialog>\n<script>" +
           std::string(report::kCardsScript) + std::string(kHardScript) + "</script>\n</body>\n</html>\n";
}

} // namespace shadowlab::hard
