// What came of a case, kept and read back; and the tables about it.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>

#include "app/context/assets.h"
#include "app/hard/page.h"
#include "app/hard/parts.h"
#include "app/hard/results_json.h"
#include "app/hard/tables.h"
#include "tests/foundation/scene/scene_files.h"

namespace shadowlab::hard {
namespace {

CaseResult made() {
    CaseResult result{"P1", "Above, \"it\"", "Why <so>.", {}, {}, {"Suite.Name"}, {"Suite.Naive"}, ""};
    Row row;
    row.caseId = "P1", row.technique = "planar", row.settings = {"planar.cull=false"};
    row.naiveSettings = {"planar.clip=false"};
    row.measured = {{"wrong", "px", "at most 0", 0, 812.0, true, false}};
    row.counts.lit = 900, row.counts.shadowed = 700;
    row.caught = true, row.ms = 1.5;
    row.right = {"P1-check-1", {1, 2}, {3}};
    row.naive = Pictures{"P1-check-1-careless", {4}, {5}};
    result.rows.push_back(row);
    const auto cell = [&](const char* column, Standing standing, int wrong, int core, bool isExact) {
        Cell one;
        one.column = column, one.standing = standing, one.isExact = isExact, one.coreErrors = core;
        one.counts.falseLit = wrong, one.counts.lit = 900, one.ms = 2.25, one.served = 0.5;
        one.pictures = {std::string("P1-") + column, {6}, {7}};
        return one;
    };
    result.cells = {cell("planar", Standing::edges, 12, 0, false), cell("ray-traced", Standing::exact, 0, 0, true),
                    cell("shadow-map", Standing::wrong, 99, 44, true)};
    return result;
}

TEST(HardResultsTest, ComeBackAsTheyWere) {
    const Json json = toJson(made());
    EXPECT_EQ(toJson(caseResultFromJson(json)), json);
    EXPECT_EQ(caseResultFromJson(json).red(), 1);
}

TEST(HardResultsTest, WhatIsExactByNatureIsRedWhereItIsWrongWithoutAReason) {
    CaseResult result = made();
    EXPECT_EQ(result.red(), 1);
    result.cells.back().reason = "Known.";
    EXPECT_EQ(result.red(), 0);
    result.cells.back().reason = "", result.cells.back().isExact = false;
    EXPECT_EQ(result.red(), 0);
    result.rows.front().caught = false;
    EXPECT_EQ(result.red(), 1);
}

TEST(HardResultsTest, ARunGoesOnWithWhatWasMadeOfTheSame) {
    const scene::TempFolder folder;
    const std::filesystem::path file = caseFiles(context::assetsRoot()).front();
    const Case one = loadCase(file, {.assetsRoot = context::assetsRoot(), .allowed = {}, .limits = {}});
    const Parts parts(folder.path(), "version 1", std::span(&one, 1));
    EXPECT_FALSE(parts.find(one));
    parts.keep(one, made());
    for (const char* picture : {"P1-check-1.png", "P1-check-1-careless-errors.png", "P1-planar-errors.png"})
        EXPECT_TRUE(std::filesystem::exists(folder.path() / "pictures" / picture)) << picture;
    ASSERT_TRUE(parts.find(one));
    EXPECT_EQ(toJson(*parts.find(one)), toJson(made()));
    EXPECT_FALSE(Parts(folder.path(), "version 2", std::span(&one, 1)).find(one)) << "made by another program";
    folder.write("pictures/P1-planar-errors.png", "another picture");
    EXPECT_FALSE(parts.find(one)) << "its pictures are not as they were";
    parts.keep(one, made());
    Case other = one;
    other.file = caseFiles(context::assetsRoot()).back();
    EXPECT_FALSE(parts.find(other)) << "its file has changed";
    folder.write("parts/a scene@key/planar.json", "{}"); // of a report in the same folder
    parts.discard(std::span(&one, 1));
    EXPECT_FALSE(parts.find(one)) << "the next run is a new one";
    EXPECT_TRUE(std::filesystem::exists(folder.path() / "parts/a scene@key/planar.json")) << "it is another's";
    std::filesystem::remove_all(folder.path() / "parts/a scene@key");
    parts.keep(one, made());
    parts.discard(std::span(&one, 1));
    EXPECT_FALSE(std::filesystem::exists(folder.path() / "parts"));
}

TEST(HardResultsTest, TablesHaveEveryTechniqueAndSayWhatIsWrong) {
    const std::vector<CaseResult> results{made()};
    const std::string csv = matrixCsv(results), page = hardPage(results, "a <renderer>");
    // The style of the table keeps its cells in one line; on a phone, where a cell begins with its column's name, it may not.
    EXPECT_GT(page.find("@media screen and (max-width: 700px) { .matrix td { white-space: normal } }"), page.find(".matrix th, .matrix td {"));
    EXPECT_NE(page.find(".matrix td { white-space: normal }"), std::string::npos);
    EXPECT_EQ(std::ranges::count(csv, '\n'), 4);
    EXPECT_NE(csv.find("P1,\"Above, \"\"it\"\"\",shadow-map,yes,wrong,99,99,0,0,44,50,2.25"), std::string::npos) << csv;
    for (const char* text : {"✗ 99", "44 core", "≈ 12", "href=\"pictures/P1-planar.png\"", "planar.clip=false",
                             "Suite.Naive", "a &lt;renderer&gt;", "class=\"wrong bad\"", "1 of 1"})
        EXPECT_NE(page.find(text), std::string::npos) << text;
    EXPECT_EQ(page.find("<so>"), std::string::npos);
}

} // namespace
} // namespace shadowlab::hard
