// SPDX-License-Identifier: MIT
#include "app/hard/tables.h"

#include <array>
#include <charconv>

#include <nlohmann/json.hpp>

#include "app/diagram/markup.h"

namespace shadowlab::hard {

namespace {

using Json = nlohmann::ordered_json;
using diagram::escapedMarkup;

std::string number(double value) {
    std::array<char, 32> text{};
    const auto [end, error] = std::to_chars(text.data(), text.data() + text.size(), value);
    return {text.data(), end};
}

std::string joined(const std::vector<std::string>& words) {
    std::string text;
    for (const std::string& word : words)
        text += (text.empty() ? "" : " ") + word;
    return text;
}

std::string caughtText(const Row& row) { return !row.caught ? "no setting" : *row.caught ? "caught" : "not caught"; }

/// In quotes where it holds what would end a field.
std::string field(const std::string& text) {
    if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
    std::string quoted = "\"";
    for (const char c : text)
        quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
    return quoted + "\"";
}

std::string cell(const std::string& text, const char* kind = "") {
    return "<td" + std::string(kind) + ">" + escapedMarkup(text) + "</td>";
}

std::string rowOf(const CaseResult& result, const Row& row) {
    std::string html;
    for (const Measured& measured : row.measured) {
        html += "<tr>" + cell(result.id) + cell(row.title.empty() ? result.title : result.title + ": " + row.title) +
                cell(row.technique) + cell(joined(row.settings)) + cell(measured.quantity + " " + measured.bound) +
                cell(number(measured.value), " class=\"n\"");
        html += measured.naive ? cell(number(*measured.naive), " class=\"n\"") + cell(joined(row.naiveSettings))
                               : cell("") + cell("");
        html += cell(std::string(toText(row.outcome)), row.outcome == Outcome::right ? "" : " class=\"bad\"") +
                cell(caughtText(row), row.caught.value_or(true) ? "" : " class=\"bad\"") + "</tr>\n";
    }
    return html;
}

constexpr std::string_view kStyle = R"(
body { margin: 1rem auto; max-width: 80rem; padding: 0 1rem; font: 15px/1.4 'DejaVu Sans', Verdana, sans-serif; color: #1a1a1a }
table { border-collapse: collapse; width: 100% } th, td { text-align: left; padding: .3rem .5rem; border-bottom: 1px solid #ccc; vertical-align: top }
th { background: #eee } .n { text-align: right } .bad { background: #e69f00; font-weight: bold }
@media print { thead { display: table-header-group } tr { break-inside: avoid } body { font-size: 8pt } }
)";

} // namespace

std::string hardJson(const std::vector<CaseResult>& results, const std::string& renderer) {
    Json cases = Json::array();
    for (const CaseResult& result : results) {
        Json rows = Json::array();
        for (const Row& row : result.rows) {
            Json measured = Json::array();
            for (const Measured& m : row.measured)
                measured.push_back({{"quantity", m.quantity},
                                    {"unit", m.unit},
                                    {"bound", m.bound},
                                    {"value", m.value},
                                    {"holds", m.holds},
                                    {"naive", m.naive ? Json(*m.naive) : Json(nullptr)}});
            rows.push_back({{"title", row.title},
                            {"technique", row.technique},
                            {"settings", row.settings},
                            {"naiveSettings", row.naiveSettings},
                            {"lit", row.counts.lit},
                            {"shadowed", row.counts.shadowed},
                            {"ties", row.counts.ties},
                            {"measured", measured},
                            {"verdict", toText(row.outcome)},
                            {"caught", row.caught ? Json(*row.caught) : Json(nullptr)},
                            {"ms", row.ms}});
        }
        cases.push_back({{"case", result.id},
                         {"title", result.title},
                         {"why", result.why},
                         {"checks", rows},
                         {"tests", result.tests}});
    }
    return Json{{"renderer", renderer}, {"cases", cases}}.dump(1) + "\n";
}

std::string hardCsv(const std::vector<CaseResult>& results) {
    std::string csv =
        "case,title,check,technique,settings,quantity,bound,value,naive,naiveSettings,lit,shadowed,ties,verdict,"
        "naiveVerdict,tests\r\n";
    for (const CaseResult& result : results) {
        std::vector<std::vector<std::string>> lines;
        for (const Row& row : result.rows)
            for (const Measured& m : row.measured)
                lines.push_back({result.id, result.title, row.title, row.technique, joined(row.settings), m.quantity,
                                 m.bound, number(m.value), m.naive ? number(*m.naive) : "", joined(row.naiveSettings),
                                 std::to_string(row.counts.lit), std::to_string(row.counts.shadowed),
                                 std::to_string(row.counts.ties), std::string(toText(row.outcome)), caughtText(row),
                                 joined(result.tests)});
        if (result.rows.empty())
            lines.push_back({result.id, result.title, "", "", "", "", "", "", "", "", "", "", "", "held by tests", "",
                             joined(result.tests)});
        for (const std::vector<std::string>& line : lines) {
            for (std::size_t i = 0; i < line.size(); ++i)
                csv += (i ? "," : "") + field(line[i]);
            csv += "\r\n";
        }
    }
    return csv;
}

std::string hardPage(const std::vector<CaseResult>& results, const std::string& renderer) {
    std::string rows, byTests;
    int checks = 0, green = 0, careless = 0, caught = 0;
    for (const CaseResult& result : results) {
        for (const Row& row : result.rows) {
            rows += rowOf(result, row);
            ++checks;
            green += row.isGreen();
            careless += row.caught.has_value();
            caught += row.caught.value_or(false);
        }
        if (result.rows.empty())
            byTests += "<tr>" + cell(result.id) + cell(result.title) + cell(result.why) + cell(joined(result.tests)) +
                       "</tr>\n";
    }
    return "<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n<title>Hard cases</title>\n<style>" +
           std::string(kStyle) + "</style>\n</head>\n<body>\n<h1>Hard cases</h1>\n<p>" + std::to_string(green) +
           " of " + std::to_string(checks) + " checks are as they have to be; " + std::to_string(caught) + " of " +
           std::to_string(careless) + " careless versions are caught. Drawn by " + escapedMarkup(renderer) +
           ".</p>\n<table>\n<thead><tr><th>case</th><th>what it is</th><th>technique</th><th>settings</th><th>has to "
           "be</th>"
           "<th>is</th><th>careless</th><th>by</th><th>verdict</th><th>careless version</th></tr></thead>\n<tbody>\n" +
           rows +
           "</tbody>\n</table>\n<h2>Held by tests alone</h2>\n<table>\n<thead><tr><th>case</th><th>what it is</th>"
           "<th>why</th><th>tests</th></tr></thead>\n<tbody>\n" +
           byTests + "</tbody>\n</table>\n</body>\n</html>\n";
}

} // namespace shadowlab::hard
