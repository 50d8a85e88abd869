// SPDX-License-Identifier: MIT
#include "app/cli/grade_text.h"

#include "app/cli/json/json_values.h"
#include "app/cli/text_table.h"
#include "app/student/grading/likely_blanks.h"
#include "app/student/grading/sheets/html_parts.h"

namespace shadowlab::cli {

namespace {

using student::CaseResult;
using student::Sheet;

std::string wrongText(const CaseResult& result) { return result.wrong ? std::to_string(*result.wrong) : "-"; }

std::string searchText(const student::SearchReport& search, const std::vector<student::Blank>& blanks) {
    std::string text = "\nSearch: " + student::toText(search) + "\n";
    if (!search.found) return text;
    const student::FoundScene& found = *search.found;
    text += found.sentence + "\n";
    if (!found.counted.empty()) text += found.counted + "\n";
    if (const std::string names = student::namesOf(found.blanks, blanks); !names.empty()) text += "Look first at " + names + ".\n";
    if (!found.scene.empty()) text += "The scene: " + found.scene + "\n";
    if (!found.lesson.empty()) text += "A lesson of it: " + found.lesson + "\n";
    return text;
}

} // namespace

std::string sheetText(const GradedSheet& graded, std::optional<std::size_t> columns) {
    const Sheet& sheet = graded.sheet;
    std::string text = std::string(sheet.family->title) + ": " + sheet.candidate.technique + " (" +
                       sheet.candidate.plugin.filename().string() + ")\n\n";
    Rows rows{{"case", "wrong px", "limit", "points", "  idea"}};
    for (const CaseResult& result : sheet.results)
        rows.push_back({std::string(result.which->id), wrongText(result), std::to_string(result.which->limit),
                        std::to_string(result.points()) + "/" + std::to_string(result.which->points),
                        "  " + std::string(result.which->idea)});
    rows.push_back({"sum", "", "", std::to_string(sheet.points()) + "/" + std::to_string(sheet.mostPoints()), ""});
    text += aligned(rows, columns);
    for (const CaseResult& result : sheet.results)
        if (!result.isRight())
            text += "\n" + std::string(result.which->id) + ": " + student::caseText(result, *sheet.family, graded.blanks) + "\n";
    if (const std::string likely = student::likelyText(sheet, graded.blanks); !likely.empty()) text += "\n" + likely + "\n";
    if (!graded.picture.empty()) text += "\nThe first failing case: " + graded.picture + "\n";
    if (graded.search) text += searchText(*graded.search, graded.blanks);
    return fitting(text, columns);
}

std::string sheetJson(const GradedSheet& graded) {
    const Sheet& sheet = graded.sheet;
    Json cases = Json::array();
    for (const CaseResult& result : sheet.results)
        cases.push_back({{"case", result.which->id},
                         {"idea", result.which->idea},
                         {"judged", student::toText(result.which->judged)},
                         {"wrong", result.wrong ? Json(*result.wrong) : Json(nullptr)},
                         {"falseLit", result.wrong ? Json(result.counts.falseLit) : Json(nullptr)},
                         {"falseShadow", result.wrong ? Json(result.counts.falseShadow) : Json(nullptr)},
                         {"lit", result.counts.lit},
                         {"shadowed", result.counts.shadowed},
                         {"limit", result.which->limit},
                         {"reason", result.which->reason},
                         {"points", result.points()},
                         {"of", result.which->points},
                         {"failure", result.failure},
                         {"hint", student::hintOf(result)},
                         {"blanks", graded.blanks.empty() ? std::vector<int>() : student::numbersIn(result.which->blanks)}});
    Json json{{"plugin", sheet.candidate.plugin.string()},
              {"technique", sheet.candidate.technique},
              {"family", sheet.family->id},
              {"points", sheet.points()},
              {"of", sheet.mostPoints()},
              {"cases", cases},
              {"picture", graded.picture.empty() ? Json(nullptr) : Json(graded.picture)}};
    if (graded.search) {
        Json search{{"asked", graded.search->asked},
                    {"tried", graded.search->tried},
                    {"unfair", graded.search->unfair},
                    {"seed", graded.search->seed},
                    {"outOfTime", graded.search->isOutOfTime},
                    {"found", nullptr}};
        if (const auto& found = graded.search->found)
            search["found"] = {{"number", found->number},
                               {"idea", found->idea},
                               {"sentence", found->sentence},
                               {"counted", found->counted},
                               {"blanks", found->blanks},
                               {"triangles", found->triangles},
                               {"trianglesBefore", found->trianglesBefore},
                               {"attempts", found->attempts},
                               {"wrong", found->wrong},
                               {"falseLit", found->falseLit},
                               {"falseShadow", found->falseShadow},
                               {"scene", textJson(found->scene)},
                               {"lesson", textJson(found->lesson)}};
        json["search"] = search;
    }
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

} // namespace shadowlab::cli
