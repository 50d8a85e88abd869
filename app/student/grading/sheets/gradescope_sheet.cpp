// SPDX-License-Identifier: MIT
#include <nlohmann/json.hpp>

#include "app/student/grading/likely_blanks.h"
#include "app/student/grading/sheets/html_parts.h"
#include "app/student/grading/sheets/sheets.h"

namespace shadowlab::student {

std::string gradescopeSheet(const Sheet& sheet, const std::vector<Blank>& blanks, const std::optional<SearchReport>& search) {
    using Json = nlohmann::ordered_json;
    Json tests = Json::array();
    int number = 0;
    for (const CaseResult& result : sheet.results)
        tests.push_back({{"name", std::string(result.which->id) + ": " + std::string(result.which->idea)},
                         {"number", std::to_string(++number)},
                         {"score", result.points()},
                         {"max_score", result.which->points},
                         {"status", result.isRight() ? "passed" : "failed"},
                         {"output", caseHtml(result, *sheet.family, blanks)},
                         {"output_format", "html"},
                         {"visibility", "visible"}});
    // Worth no points: the marks are those of the cases, which are the same for all.
    if (search)
        tests.push_back({{"name", "Search for a failing scene"},
                         {"number", std::to_string(++number)},
                         {"score", 0},
                         {"max_score", 0},
                         {"status", search->found ? "failed" : "passed"},
                         {"output", searchHtml(*search, blanks)},
                         {"output_format", "html"},
                         {"visibility", "visible"}});
    std::string output = std::string(sheet.family->title) + ": " + std::to_string(sheet.points()) + " of " +
                         std::to_string(sheet.mostPoints()) + " points.";
    if (const std::string likely = likelyText(sheet, blanks); !likely.empty())
        output += " " + likely;
    const Json results{{"score", sheet.points()},
                       {"output", output},
                       {"output_format", "text"},
                       {"visibility", "visible"},
                       {"stdout_visibility", "hidden"},
                       {"tests", tests}};
    return results.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

} // namespace shadowlab::student
