// SPDX-License-Identifier: MIT
#include <nlohmann/json.hpp>

#include "app/drawing/markup.h"
#include "app/student/grading/likely_blanks.h"
#include "app/student/grading/sheets/html_parts.h"
#include "app/student/grading/sheets/sheets.h"

namespace shadowlab::student {

std::string coderunnerSheet(const Sheet& sheet, const std::vector<Blank>& blanks, const std::optional<SearchReport>& search) {
    using Json = nlohmann::ordered_json;
    // The first row are the headings. A column `iscorrect` is shown as a tick or a cross, and has no format of its own.
    Json rows = Json::array();
    rows.push_back({"iscorrect", "Case", "Idea", "Wrong pixels", "Points", "What is seen"});
    for (const CaseResult& result : sheet.results)
        rows.push_back({result.isRight() ? 1 : 0, result.which->id, result.which->idea,
                        result.wrong ? std::to_string(*result.wrong) : "no picture",
                        std::to_string(result.points()) + "/" + std::to_string(result.which->points),
                        caseHtml(result, *sheet.family, blanks)});
    std::string before = "<p>" + drawing::escapedMarkup(sheet.family->title) + ": " + std::to_string(sheet.points()) + " of " +
                         std::to_string(sheet.mostPoints()) + " points.</p>";
    if (const std::string likely = likelyText(sheet, blanks); !likely.empty())
        before += "<p>" + drawing::escapedMarkup(likely) + "</p>";
    const Json outcome{{"fraction", static_cast<double>(sheet.points()) / sheet.mostPoints()},
                       {"prologuehtml", before},
                       {"testresults", rows},
                       {"columnformats", {"%s", "%s", "%s", "%s", "%h"}},
                       {"epiloguehtml", search ? searchHtml(*search, blanks) : ""},
                       {"showdifferences", false}};
    return outcome.dump(-1, ' ', true, Json::error_handler_t::replace) + "\n";
}

} // namespace shadowlab::student
