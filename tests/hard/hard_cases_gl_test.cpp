// Every hard case at its small size: what is right is green, and each careless version turns its check red.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <regex>
#include <set>

#include "app/context/assets.h"
#include "app/hard/run_case.h"
#include "techniques/foundation/base/error.h"
#include "techniques/registry.h"
#include "tests/support/gl_fixture.h"

namespace shadowlab::hard {
namespace {

// Fewer, and files have been lost.
constexpr std::size_t kLeastCases = 80, kLeastChecks = 57, kLeastCareless = 40;

scene::LoadOptions loading() { return {.assetsRoot = context::assetsRoot(), .allowed = {}, .limits = {}}; }

class HardCasesTest : public testing::GlTest {};

TEST_F(HardCasesTest, AreRightAndCarelessVersionsAreCaught) {
    std::size_t checks = 0, careless = 0;
    const std::vector<Case> cases = allCases(loading());
    EXPECT_GE(cases.size(), kLeastCases);
    for (const Case& one : cases)
        for (const Row& row : runCase(one, true)) {
            SCOPED_TRACE(row.caseId + " " + row.title + " " + row.technique);
            ++checks;
            careless += row.caught ? 1 : 0;
            EXPECT_EQ(toText(row.outcome), toText(Outcome::right));
            for (const Measured& measured : row.measured) {
                std::cout << row.caseId << " " << row.technique << ": " << measured.quantity << " " << measured.value
                          << " (" << measured.bound << ")";
                if (measured.naive) std::cout << ", careless: " << *measured.naive;
                std::cout << "; " << row.counts.lit << " lit, " << row.counts.shadowed << " in shadow\n";
                EXPECT_TRUE(measured.holds) << measured.quantity << " is " << measured.value;
            }
            if (row.caught) {
                EXPECT_TRUE(*row.caught) << "the careless version passes: the check sees nothing";
            }
        }
    EXPECT_GE(checks, kLeastChecks);
    EXPECT_GE(careless, kLeastCareless);
}

// What asks rays wherever a rasteriser may err is right before every scene, whoever the case is about.
TEST_F(HardCasesTest, WhatIsExactByItsNatureIsRightBeforeAllScenes) {
    std::vector<Column> exact = columns();
    std::erase_if(exact, [](const Column& column) { return !column.isExact; });
    EXPECT_GE(exact.size(), 6u);
    std::size_t compared = 0, limits = 0, reasons = 0;
    for (Case one : allCases(loading())) {
        one.checks.clear();
        limits += one.limits.size();
        for (const Cell& cell : runWholeCase(one, true, exact).cells) {
            EXPECT_TRUE(cell.standing == Standing::exact || !cell.reason.empty())
                << one.id << ", " << cell.column << ": " << toText(cell.standing) << ", " << cell.wrong() << " wrong, "
                << cell.coreErrors << " core errors";
            reasons += !cell.reason.empty();
            ++compared;
        }
    }
    EXPECT_GE(compared, 150u);
    EXPECT_LE(reasons, limits);
}

// Columns are every technique of the list, once as it is, in the order of the list.
TEST_F(HardCasesTest, TheTableHasAColumnForEveryTechnique) {
    std::vector<std::string> expected, found;
    for (const RegisteredTechnique& technique : techniquesOf(TechniqueGroup::production))
        if (std::ranges::find(technique.info->stages, "visibility", &StageInfo::id) != technique.info->stages.end())
            expected.emplace_back(technique.info->id);
    for (const Column& column : columns())
        if (column.values.empty()) found.push_back(column.technique);
    EXPECT_EQ(found, expected);
    EXPECT_GE(found.size(), 8u);
}

// A limit that names no column, or one that is right, says something that is not so.
TEST_F(HardCasesTest, LimitsAreOfWhatIsWrong) {
    const std::vector<Column> all = columns();
    std::size_t reasons = 0, limits = 0;
    for (Case one : allCases(loading())) {
        if (one.limits.empty()) continue;
        one.checks.clear();
        limits += one.limits.size();
        for (const Cell& cell : runWholeCase(one, true, all).cells)
            reasons += cell.standing == Standing::wrong && !cell.reason.empty();
    }
    EXPECT_EQ(reasons, limits);
    EXPECT_GE(limits, 6u);
}

// A case without anything in shadow proves nothing, however right the picture is; one whose careless version is no worse is red.
TEST_F(HardCasesTest, TheSuiteItselfCanBeRed) {
    std::vector<Case> cases = allCases(loading());
    ASSERT_FALSE(cases.empty());
    Case one = cases.front();
    ASSERT_TRUE(one.checks.front().naive);
    one.least.shadowed = one.size.x * one.size.y;
    EXPECT_EQ(runCase(one, true).front().outcome, Outcome::provesNothing);
    one.least.shadowed = 0;
    std::swap(one.checks.front().right, *one.checks.front().naive);
    const Row swapped = runCase(one, true).front();
    EXPECT_EQ(swapped.outcome, Outcome::wrong);
    EXPECT_FALSE(*swapped.caught);
    EXPECT_FALSE(swapped.isGreen());
}

// A test may be renamed where it stands: then the case would point at nothing.
TEST(HardCaseFilesTest, NameTestsThatThereAre) {
    std::set<std::string> known;
    const std::regex test(R"(TEST(?:_F|_P)?\(\s*(\w+),\s*(\w+)\s*\))");
    for (const auto& entry : std::filesystem::recursive_directory_iterator(SHADOWLAB_SOURCE_DIR "/tests")) {
        if (entry.path().extension() != ".cpp") continue;
        std::ifstream file(entry.path());
        const std::string text((std::istreambuf_iterator<char>(file)), {});
        for (std::sregex_iterator found(text.begin(), text.end(), test), end; found != end; ++found)
            known.insert((*found)[1].str() + "." + (*found)[2].str());
    }
    EXPECT_GT(known.size(), 500u);
    std::size_t named = 0;
    for (const Case& one : allCases(loading()))
        for (const auto& names : {one.tests, one.naiveTests})
            for (const std::string& name : names) {
                EXPECT_TRUE(known.contains(name)) << one.id << " names " << name;
                ++named;
            }
    EXPECT_GE(named, kLeastCases);
}

TEST(HardCaseFilesTest, WhatACaseMayNotSayIsNamedByItsPlace) {
    const std::string text = R"({"case": "P1", "title": "T", "why": "W.", "scene": "still-life", "checks": [
  {"technique": "planar", "expect": [{"quantity": "wrong", "atMost": 0}], "naive": {"set": ["planar.clip=false"]}}]})";
    EXPECT_EQ(parseCase(text, "x.json", loading()).checks.size(), 1u);
    const auto refused = [&](const std::string& what, const std::string& by, const std::string& because) {
        std::string other = text;
        other.replace(other.find(what), what.size(), by);
        try {
            parseCase(other, "x.json", loading());
            ADD_FAILURE() << by << " was taken";
        } catch (const Error& error) {
            EXPECT_EQ(error.status(), ExitStatus::badInput);
            EXPECT_NE(std::string(error.what()).find("x.json:"), std::string::npos) << error.what();
            EXPECT_NE(std::string(error.what()).find(because), std::string::npos) << error.what();
        }
    };
    refused("\"P1\"", "\"Q1\"", "family");
    refused("\"atMost\": 0", "\"most\": 0", "most");
    refused(", \"atMost\": 0", "", "no bound");
    refused("\"wrong\"", "\"wrogn\"", "wrong");
    refused("planar.clip=false", "planar.clip=true", "changes nothing");
    refused("\"planar\"", "\"planer\"", "planar");
    refused("\"wrong\"", "\"differing\"", "from");
    refused(R"(, "naive": {"set": ["planar.clip=false"]})", "", "careless");
    refused(R"("scene": )", R"("withoutNaive": "None.", "scene": )", "careless");
}

TEST(HardCaseFilesTest, StandInTheOrderOfTheList) {
    EXPECT_TRUE(isBefore("P2", "P2b"));
    EXPECT_TRUE(isBefore("P2c", "P12"));
    EXPECT_TRUE(isBefore("P12", "M1"));
    EXPECT_TRUE(isBefore("V20", "R1"));
    EXPECT_FALSE(isBefore("F1", "R1"));
}

} // namespace
} // namespace shadowlab::hard
