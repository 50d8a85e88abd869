// The two tables that show the whole suite at once.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <map>

#include "app/drawing/markup.h"
#include "app/hard/page.h"
#include "app/hard/tables.h"
#include "app/report/csv.h"
#include "app/report/page/log_axis.h"

namespace shadowlab::hard {

using report::joined;
using report::numberText;

namespace {

using drawing::escapedMarkup;

/// The sign that stands beside the colour, and the class that has it.
struct Look {
    const char *sign, *kind;
};
Look lookOf(Standing standing) {
    switch (standing) {
    case Standing::exact: return {"✓", "exact"};
    case Standing::edges: return {"≈", "edges"};
    case Standing::wrong: return {"✗", "wrong"};
    case Standing::provesNothing: return {"?", "nothing"};
    case Standing::refused: return {"–", "nothing"};
    }
    return {"", ""};
}

std::string factsOf(const Cell& cell) {
    const judge::Counts& c = cell.counts;
    std::string facts = std::string(toText(cell.standing)) + ". ";
    if (cell.standing != Standing::refused)
        facts += std::to_string(c.falseLit) + " false lit, " + std::to_string(c.falseShadow) + " false shadow" +
                 (c.stray > 0 ? ", " + std::to_string(c.stray) + " stray" : "") + ", of these " +
                 std::to_string(cell.coreErrors) + " core errors; of " + std::to_string(c.pixels) + " pixels " +
                 std::to_string(c.lit) + " are lit, " + std::to_string(c.shadowed) + " in shadow, " +
                 std::to_string(c.turnedAway) + " turned away, " + std::to_string(c.ties) + " ties. " +
                 report::threeDigits(100 * cell.served) + " % served, " + report::threeDigits(cell.ms) + " ms.";
    return facts + (cell.reason.empty() ? "" : " " + cell.reason);
}

std::string cellMarkup(const CaseResult& result, const Cell& cell) {
    const Look look = lookOf(cell.standing);
    const bool isNumber = cell.standing == Standing::edges || cell.standing == Standing::wrong;
    std::string text = look.sign;
    if (isNumber) text += " " + std::to_string(cell.wrong());
    std::string small;
    if (cell.standing == Standing::wrong) small += std::to_string(cell.coreErrors) + " core";
    if (cell.standing != Standing::refused) small += (small.empty() ? "" : ", ") + report::threeDigits(cell.ms) + " ms";
    // Marked clearly: this result had to be exact and is not, and no reason is known.
    const std::string kind = std::string(look.kind) + (cell.isGreen() ? "" : " bad");
    return "<td class=\"" + kind + "\">" +
           pictureLink(cell.pictures, text, result.id + ", " + cell.column, factsOf(cell)) + "<br><small>" + small +
           (cell.reason.empty() ? "" : " *") + "</small></td>";
}

constexpr std::string_view kLegend =
    "<p class=\"legend\"><span class=\"exact\">✓</span> no pixel is wrong <span class=\"edges\">≈ 12</span> so many "
    "are, "
    "but only as aliasing makes them <span class=\"wrong\">✗ 345</span> core errors: wrong away from any shadow's edge "
    "<span class=\"nothing\">– or ?</span> not drawn, or too little is lit or dark to prove anything. * there is a "
    "reason, below. Bold columns are exact by their nature.</p>\n";

} // namespace

std::string matrixTable(const std::vector<CaseResult>& results) {
    const auto first = std::ranges::find_if(results, [](const CaseResult& r) { return !r.cells.empty(); });
    if (first == results.end()) return "";
    std::string html = "<h2 class=\"first\" id=\"matrix\">Every technique before every case</h2>\n<p>Pixels that are "
                       "wrong; below them the core errors among these, and the time of a frame in which the light has "
                       "moved by one degree. A number opens the picture.</p>\n" +
                       std::string(kLegend) +
                       "<div class=\"wide\"><table class=\"matrix\"><thead><tr><th scope=\"col\" "
                       "class=\"text\">case</th>";
    for (const Cell& cell : first->cells)
        html += std::string("<th scope=\"col\"") + (cell.isExact ? "" : " class=\"plain\"") + ">" +
                escapedMarkup(cell.column) + "</th>";
    html += "</tr></thead>\n<tbody>\n";
    std::string reasons;
    for (const CaseResult& result : results) {
        if (result.cells.empty()) continue;
        html += "<tr><th scope=\"row\" class=\"text\" title=\"" + escapedMarkup(result.why) + "\">" + result.id +
                " <span>" + escapedMarkup(result.title) + "</span></th>";
        for (const Cell& cell : result.cells) {
            html += cellMarkup(result, cell);
            if (!cell.reason.empty())
                reasons += "<li>" + result.id + ", " + escapedMarkup(cell.column) + ": " + escapedMarkup(cell.reason) +
                           "</li>\n";
        }
        html += "</tr>\n";
    }
    html += "</tbody></table></div>\n";
    return reasons.empty() ? html : html + "<p>* Reasons:</p>\n<ul>\n" + reasons + "</ul>\n";
}

std::string carelessTable(const std::vector<CaseResult>& results) {
    struct Switched {
        int red = 0, runs = 0;
        std::string where;
    };
    std::map<std::string, Switched> switches;
    std::string others;
    for (const CaseResult& result : results) {
        for (const Row& row : result.rows) {
            if (!row.caught) continue;
            Switched& one = switches[joined(row.naiveSettings)];
            ++one.runs;
            one.red += *row.caught;
            const auto found = std::ranges::find(row.measured, false, &Measured::naiveHolds);
            if (found != row.measured.end())
                one.where += (one.where.empty() ? "" : "; ") + result.id + ": " + found->quantity + " " +
                             numberText(*found->naive) + ", has to be " + found->bound;
        }
        if (!result.naiveTests.empty())
            others += "<tr>" + tableCell("in the test", "text") + tableCell(result.id, "text") +
                      tableCell("red", "text") + tableCell(joined(result.naiveTests), "text tests") + "</tr>\n";
        if (!result.withoutNaive.empty())
            others += "<tr>" + tableCell("none", "text") + tableCell(result.id, "text") + tableCell("–", "text") +
                      tableCell(result.withoutNaive, "text") + "</tr>\n";
    }
    std::string rows;
    for (const auto& [setting, one] : switches)
        rows += "<tr>" + tableCell(setting, "text") +
                tableCell(std::to_string(one.red) + " of " + std::to_string(one.runs), "text") +
                tableCell(one.red == one.runs ? "red" : "not always red", one.red == one.runs ? "text" : "text bad") +
                tableCell(one.where, "text") + "</tr>\n";
    return "<h2 id=\"careless\">Careless versions</h2>\n<p>Each is switched on, and the suite has to be red with it: a "
           "setting in the checks of this page, all else in tests that switch it on where no setting does.</p>\n"
           "<div class=\"wide\"><table><thead><tr><th scope=\"col\" class=\"text\">switched on by</th><th "
           "scope=\"col\" "
           "class=\"text\">checks, or case</th><th scope=\"col\" class=\"text\">the suite is</th><th scope=\"col\" "
           "class=\"text\">found out by</th></tr></thead>\n<tbody>\n" +
           rows + others + "</tbody></table></div>\n";
}

} // namespace shadowlab::hard
