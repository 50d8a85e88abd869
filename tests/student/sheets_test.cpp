// The score sheet in the forms that others read, each held against what is published of it.
// SPDX-License-Identifier: MIT
#include "app/student/grading/sheets/sheets.h"

#include <gtest/gtest.h>

#include <regex>
#include <set>

#include <nlohmann/json.hpp>

#include "app/student/grading/likely_blanks.h"
#include "app/student/search/finding_text.h"
#include "app/student/skeletons.h"
#include "techniques/foundation/image/png/png.h"

namespace shadowlab::student {
namespace {

using nlohmann::json;

/// Of planar shadows: the first case is right, the second draws another picture, the third none; all others are right.
Sheet someSheet() {
    Sheet sheet{&findFamily("planar"), {"folder/<b>anna</b>.so", "a-planar", "auto"}, {}};
    for (const Case& which : sheet.family->cases)
        sheet.results.push_back({&which, 0, "", {}, {}});
    sheet.results[1].wrong = 4711;
    sheet.results[1].counts.falseLit = 4711;
    sheet.results[2].wrong.reset();
    sheet.results[2].failure = "it said \"<script>alert(1)</script>\" & ended\x01";
    for (const std::size_t failing : {1u, 2u})
        sheet.results[failing].picture = image::Image(6, 4, {200, 100, static_cast<std::uint8_t>(failing), 255});
    return sheet;
}

SearchReport someReport() {
    SearchReport report{60, 3, 1, 5, false, FoundScene{}};
    report.found->idea = "a body that is sunk into the floor";
    report.found->sentence = "Two triangles and a lamp: here your shadow is missing.";
    report.found->blanks = {4};
    report.found->picture = "\x89PNG of no matter";
    report.found->figure = "<svg/>";
    return report;
}

/// Of a plug-in that was made from the first skeleton of the family that has blanks.
std::vector<Blank> blanksOf(const Family& family) {
    for (const std::string& name : skeletonNames())
        if (std::vector<Blank> blanks = blanksOf(family, name); !blanks.empty()) return blanks;
    return {};
}

std::vector<Blank> planarBlanks() { return blanksOf(findFamily("planar")); }

/// What https://gradescope-autograders.readthedocs.io/en/latest/specs/ says of results.json: the keys, what they may hold, and that there
/// is a score above or at every test.
std::string gradescopeFault(const json& results) {
    const std::set<std::string> top = {"score", "execution_time", "output", "output_format", "test_output_format", "test_name_format",
                                       "visibility", "stdout_visibility", "extra_data", "tests", "leaderboard"},
                                test = {"score", "max_score", "status", "name", "name_format", "number", "output", "output_format", "tags",
                                        "visibility", "extra_data"},
                                formats = {"text", "html", "simple_format", "md", "ansi"},
                                visibilities = {"hidden", "after_due_date", "after_published", "visible"};
    const auto faultOf = [&](const json& object, const std::set<std::string>& keys) -> std::string {
        if (!object.is_object()) return "no object";
        for (const auto& [key, value] : object.items()) {
            if (!keys.contains(key)) return "unknown key " + key;
            if ((key == "score" || key == "max_score" || key == "execution_time") && !value.is_number()) return key + " is no number";
            if ((key == "name" || key == "output" || key == "number") && !value.is_string()) return key + " is no text";
            if (key.ends_with("format") && !formats.contains(value.get<std::string>())) return key + " is no format";
            if (key.ends_with("visibility") && !visibilities.contains(value.get<std::string>())) return key + " is none";
            if (key == "status" && value != "passed" && value != "failed") return "status is neither passed nor failed";
        }
        return "";
    };
    if (std::string fault = faultOf(results, top); !fault.empty()) return fault;
    if (!results.contains("score") && !results.contains("tests")) return "neither a score nor tests";
    for (const json& one : results.value("tests", json::array())) {
        if (std::string fault = faultOf(one, test); !fault.empty()) return fault;
        if (!results.contains("score") && !one.contains("score")) return "a test without a score";
    }
    return "";
}

/// What CodeRunner's combinator_grader_outcome and jobrunner check: only these keys; a fraction from 0 to 1; a table of rows as long as the
/// headings; one format, %s or %h, for each column but iscorrect and ishidden.
std::string coderunnerFault(const json& outcome) {
    const std::set<std::string> keys = {"fraction", "prologuehtml", "testresults", "epiloguehtml", "feedbackhtml", "columnformats",
                                        "showdifferences", "showoutputonly", "graderstate", "instructorhtml"};
    for (const auto& [key, value] : outcome.items())
        if (!keys.contains(key)) return "unknown key " + key;
    if (!outcome.contains("fraction") || !outcome["fraction"].is_number()) return "no fraction";
    if (const double fraction = outcome["fraction"]; fraction < 0 || fraction > 1) return "fraction out of range";
    for (const char* key : {"prologuehtml", "epiloguehtml"})
        if (outcome.contains(key) && !outcome[key].is_string()) return std::string(key) + " is no text";
    const json rows = outcome.value("testresults", json::array());
    if (rows.empty()) return "";
    std::size_t columns = 0;
    for (const json& heading : rows[0])
        columns += heading != "iscorrect" && heading != "ishidden";
    for (const json& row : rows)
        if (row.size() != rows[0].size()) return "a row of another length";
    if (outcome.contains("columnformats")) {
        if (outcome["columnformats"].size() != columns) return "wrong number of formats";
        for (const json& format : outcome["columnformats"])
            if (format != "%s" && format != "%h") return "illegal format";
    }
    return "";
}

std::size_t count(const std::string& text, const std::string& part) {
    std::size_t found = 0;
    for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1))
        ++found;
    return found;
}

/// No markup of a plug-in's, and nothing that is fetched from elsewhere.
void expectSelfContained(const std::string& html) {
    EXPECT_EQ(html.find("<script"), std::string::npos);
    EXPECT_EQ(html.find("<b>anna"), std::string::npos);
    EXPECT_EQ(html.find('\x01'), std::string::npos);
    const std::regex source(R"((?:src|href)=\"([^\"]{0,20}))");
    int sources = 0;
    for (std::sregex_iterator found(html.begin(), html.end(), source), end; found != end; ++found, ++sources)
        EXPECT_TRUE((*found)[1].str().starts_with("data:image/") || (*found)[1].str().starts_with("#")) << (*found)[1];
    EXPECT_GE(sources, 2);
    EXPECT_EQ(html.find("http:"), std::string::npos);
    EXPECT_EQ(html.find("https:"), std::string::npos);
    EXPECT_EQ(html.find("url("), std::string::npos);
}

TEST(SheetsTest, GradescopeReadsTheResults) {
    const Sheet sheet = someSheet();
    const json results = json::parse(gradescopeSheet(sheet, planarBlanks(), someReport()));
    EXPECT_EQ(gradescopeFault(results), "");
    EXPECT_EQ(results["score"], sheet.points());
    ASSERT_EQ(results["tests"].size(), sheet.results.size() + 1) << "the cases, and the search";
    double most = 0, sum = 0;
    for (const json& test : results["tests"]) {
        most += test["max_score"].get<double>();
        sum += test["score"].get<double>();
    }
    EXPECT_EQ(most, sheet.mostPoints());
    EXPECT_EQ(sum, sheet.points());
    EXPECT_EQ(results["tests"][0]["status"], "passed");
    for (const std::size_t failing : {1u, 2u}) {
        const json& test = results["tests"][failing];
        EXPECT_EQ(test["status"], "failed");
        EXPECT_EQ(count(test["output"], "data:image/png;base64,"), 1u);
        // A picture has a hint and its blanks; what ended before has neither.
        EXPECT_EQ(test["output"].get<std::string>().find("The case tests blank 1 (the projection matrix)") != std::string::npos, failing == 1u);
        expectSelfContained(test["output"].get<std::string>() + results["tests"].back()["output"].get<std::string>());
    }
    EXPECT_EQ(results["tests"].back()["status"], "failed");
    // The checker finds what is wrong.
    json other = results;
    other["tests"][0]["status"] = "right";
    EXPECT_NE(gradescopeFault(other), "");
    other = results;
    other["tests"][0]["points"] = 1;
    EXPECT_NE(gradescopeFault(other), "");
    other = results;
    other["output_format"] = "htm";
    EXPECT_NE(gradescopeFault(other), "");
}

TEST(SheetsTest, CodeRunnerReadsTheOutcome) {
    const Sheet sheet = someSheet();
    const std::string text = coderunnerSheet(sheet, planarBlanks(), someReport());
    EXPECT_EQ(count(text, "\n"), 1u) << "one line: what a grader prints";
    const json outcome = json::parse(text);
    EXPECT_EQ(coderunnerFault(outcome), "");
    EXPECT_DOUBLE_EQ(outcome["fraction"].get<double>(), double(sheet.points()) / sheet.mostPoints());
    ASSERT_EQ(outcome["testresults"].size(), sheet.results.size() + 1) << "the headings, and the cases";
    EXPECT_EQ(outcome["testresults"][1][0], 1);
    for (const std::size_t failing : {2u, 3u}) {
        EXPECT_EQ(outcome["testresults"][failing][0], 0);
        EXPECT_EQ(count(outcome["testresults"][failing].back(), "data:image/png;base64,"), 1u);
        expectSelfContained(outcome["testresults"][failing].back().get<std::string>() + outcome["epiloguehtml"].get<std::string>());
    }
    EXPECT_EQ(outcome["columnformats"].back(), "%h") << "pictures are no text";
    json other = outcome;
    other["columnformats"].push_back("%s");
    EXPECT_EQ(coderunnerFault(other), "wrong number of formats");
    other = outcome;
    other["score"] = 1;
    EXPECT_EQ(coderunnerFault(other), "unknown key score");
    EXPECT_EQ(coderunnerFault(json::parse(coderunnerSheet(sheet, planarBlanks(), std::nullopt))), "");
}

TEST(SheetsTest, ThePageHasAPictureOfEveryFailingCaseAndNothingFromElsewhere) {
    const Sheet sheet = someSheet();
    const std::string html = htmlSheet(sheet, planarBlanks(), someReport());
    expectSelfContained(html);
    EXPECT_EQ(count(html, "data:image/png;base64,"), 3u) << "two cases, and the scene that was found";
    EXPECT_EQ(count(html, "data:image/svg+xml;base64,"), 1u);
    EXPECT_EQ(count(html, "<section "), 3u);
    EXPECT_NE(html.find("Two triangles and a lamp"), std::string::npos);
    for (const CaseResult& result : sheet.results)
        EXPECT_NE(html.find(std::string(result.which->id)), std::string::npos) << result.which->id;
    EXPECT_EQ(count(htmlSheet({sheet.family, sheet.candidate, {sheet.results[0]}}, planarBlanks(), std::nullopt), "<img"), 0u);
}

TEST(SheetsTest, EveryCaseSaysWhichBlanksItIsAbout) {
    int cases = 0;
    for (const Family& family : families()) {
        const std::vector<Blank> blanks = blanksOf(family);
        std::set<int> asked;
        for (const Case& which : family.cases) {
            ++cases;
            const std::vector<int> numbers = numbersIn(which.blanks);
            EXPECT_FALSE(numbers.empty()) << which.id;
            for (const int number : numbers) {
                ASSERT_GE(number, 1) << which.id;
                ASSERT_LE(number, static_cast<int>(blanks.size())) << which.id;
                asked.insert(number);
            }
            EXPECT_NE(namesOf(numbers, blanks).find(blanks[static_cast<std::size_t>(numbers[0]) - 1].idea), std::string::npos);
        }
        EXPECT_EQ(asked.size(), blanks.size()) << family.id << ": a blank that no case is about";
    }
    EXPECT_GE(cases, 40);
}

TEST(SheetsTest, NoBlankIsNamedOfAPlugInThatHasNone) {
    const Family& planar = findFamily("planar");
    EXPECT_EQ(blanksOf(planar, "planar").size(), 4u);
    for (const char* other : {"", "empty", "z-fail", "../grading/flat-sun"})
        EXPECT_TRUE(blanksOf(planar, other).empty()) << other;
    SearchReport report = someReport();
    report.found->sentence = "Wrong.";
    const std::string html = htmlSheet(someSheet(), {}, report);
    EXPECT_GT(html.size(), 1000u);
    EXPECT_EQ(html.find("blank"), std::string::npos);
    EXPECT_EQ(namesOf({1, 2}, {}), "");
}

TEST(SheetsTest, ASkeletonIsKnownByTheAnchorsOfItsBlanks) {
    const auto pluginWith = [](const EmbeddedSource& source) {
        Plugin plugin;
        plugin.sources = {&source, 1};
        return plugin;
    };
    int known = 0;
    for (const std::string& name : skeletonNames()) {
        std::string all;
        for (const auto& [file, text] : skeletonFiles(name))
            all += text;
        const EmbeddedSource source{"technique.cpp", all};
        EXPECT_EQ(skeletonOf(pluginWith(source)), name == "empty" ? "" : name);
        ++known;
    }
    EXPECT_EQ(known, 6);
    const EmbeddedSource one{"technique.cpp", "// [anchor: x-projection-matrix]\n"};
    EXPECT_EQ(skeletonOf(pluginWith(one)), "") << "one blank of four";
}

TEST(SheetsTest, AStageThatIsWrongRulesOutTheBlanksThatComeAfterIt) {
    int asked = 0;
    const auto about = [&](const char* family, const char* stage) {
        Finding finding;
        finding.kind = kindsOf(findFamily(family)).data();
        finding.stage = StageEvidence{stage, false};
        const std::vector<Blank> blanks = blanksOf(findFamily(family));
        std::vector<int> all;
        for (std::size_t i = 1; i <= blanks.size(); ++i)
            all.push_back(static_cast<int>(i));
        ++asked;
        EXPECT_TRUE(blanksAbout(finding, findFamily(family), {}, all).empty()) << "a plug-in without blanks";
        return blanksAbout(finding, findFamily(family), blanks, all);
    };
    EXPECT_EQ(about("shadow-map", "light-depth"), (std::vector<int>{1, 2, 3}));
    EXPECT_EQ(about("shadow-map", "depth-on-view"), (std::vector<int>{1, 2, 3, 4})) << "not the comparison";
    EXPECT_EQ(about("shadow-map", "distance-on-view"), (std::vector<int>{1, 2, 4}));
    EXPECT_EQ(about("shadow-map", "comparison"), (std::vector<int>{1, 2, 3, 4, 5}));
    EXPECT_EQ(about("shadow-volume", "volume-parts"), (std::vector<int>{1, 2, 3, 4}));
    EXPECT_EQ(about("shadow-volume", "stencil-back"), (std::vector<int>{1, 2, 3, 4, 5, 7}));
    EXPECT_EQ(about("radiosity", "row-sums"), (std::vector<int>{1, 2, 3}));
    EXPECT_EQ(asked, 7);
    // Cases that point only at what the stage rules out.
    Finding finding;
    finding.kind = kindsOf(findFamily("shadow-map")).data();
    finding.stage = StageEvidence{"depth-on-view", false};
    EXPECT_EQ(blanksAbout(finding, findFamily("shadow-map"), blanksOf(findFamily("shadow-map")), {5}), (std::vector<int>{1, 2, 3, 4}));
}

TEST(SheetsTest, WhatFailsTellsTheBlankWhereItCan) {
    Sheet sheet = someSheet();
    EXPECT_TRUE(likelyBlanks(sheet).empty()) << "without a picture nothing is told";
    for (CaseResult& result : sheet.results)
        result.wrong = result.which->id == "flat-above-lamp" || result.which->id == "flat-screen" ? 0 : 5000;
    EXPECT_EQ(failingCases(sheet), "110111101");
    EXPECT_EQ(likelyBlanks(sheet), std::vector<int>{4});
    EXPECT_EQ(likelyText(sheet, planarBlanks()), "Of the mistakes that were tried, blank 4 (what lies below the plane casts no shadow on it) left empty or "
                                                 "filled in wrongly gives just these failures: look there first.");
    EXPECT_EQ(likelyText(sheet, {}), "");
    for (CaseResult& result : sheet.results)
        result.wrong = 0;
    EXPECT_TRUE(likelyBlanks(sheet).empty());
}

} // namespace
} // namespace shadowlab::student
