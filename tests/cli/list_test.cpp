// `list`, `--help`, `--version`: data on standard output, in the documented form, whatever standard output is.
// SPDX-License-Identifier: MIT
#include <nlohmann/json.hpp>

#include <algorithm>
#include <sstream>

#include <unistd.h>

#include "techniques/foundation/params/param.h"
#include "techniques/registry.h"
#include "tests/cli/command_fixture.h"

namespace shadowlab::testing {
namespace {

class ListTest : public CommandTest {};

std::vector<std::vector<std::string>> rowsOf(const std::string& text) {
    std::vector<std::vector<std::string>> rows;
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
        std::vector<std::string>& row = rows.emplace_back(1);
        for (const char c : line)
            if (c == '\t')
                row.emplace_back();
            else
                row.back() += c;
    }
    return rows;
}

TEST_F(ListTest, ParametersStandInTheirGroups) {
    const ProgramResult result = succeed({"list", "parameters"});
    EXPECT_EQ(result.err, "");
    std::vector<std::vector<std::string>> expected;
    for (const RegisteredTechnique& technique : registeredTechniques()) {
        const auto instance = technique.info->make();
        const params::ParamList list = instance->params();
        for (const params::ParamGroup& group : params::grouped(list))
            for (const params::Param* param : group.params)
                expected.push_back({std::string(technique.info->id) + "." + param->id, params::initialText(*param),
                                    params::rangeText(*param), param->unit, param->help,
                                    group.name.empty() ? "true" : "false", group.name, params::labelOf(*param),
                                    params::choicesText(*param)});
    }
    EXPECT_EQ(rowsOf(result.out), expected);
    EXPECT_NE(result.out.find("shadow-map.filter\tpcf\thard|hw2x2|pcf"), std::string::npos);
    EXPECT_NE(result.out.find("shadow-map.resolution\t2048\t64..32768\ttexels\t"), std::string::npos);
    EXPECT_NE(result.out.find("\ttrue\t\tMap resolution\t\n"), std::string::npos);
    EXPECT_NE(result.out.find("evsm: exponential variance;"), std::string::npos);
}

TEST_F(ListTest, EveryListIsLinesAndOneJsonObject) {
    for (const std::string what : {"techniques", "plugins", "parameters", "stages", "source", "scenes", "figures",
                                   "decks", "lessons", "quantities", "backends", "limits"}) {
        const auto rows = rowsOf(succeed({"list", what}).out);
        const nlohmann::json json = nlohmann::json::parse(succeed({"list", what, "--json"}).out);
        ASSERT_TRUE(json.is_object()) << what;
        ASSERT_EQ(json.size(), 1u) << what;
        ASSERT_TRUE(json.contains(what));
        EXPECT_EQ(json[what].size(), rows.size()) << what;
        for (std::size_t i = 0; i < rows.size(); ++i)
            EXPECT_EQ(json[what][i].size(), rows[i].size()) << what;
    }
}

TEST_F(ListTest, EveryBuiltInSceneIsDescribedInOneLine) {
    const auto rows = rowsOf(succeed({"list", "scenes"}).out);
    EXPECT_GE(rows.size(), 13u);
    for (const auto& row : rows) {
        ASSERT_EQ(row.size(), 2u) << row.at(0);
        EXPECT_GE(row[1].size(), 30u) << row[0];
        EXPECT_LE(row[1].size(), 160u) << row[0] << ": that is more than a line or two";
        EXPECT_TRUE(row[1].ends_with('.')) << row[0] << ": " << row[1];
    }
}

// It says how long each list is. It asks no graphics driver: also without one it is there at once, and says nothing of that.
TEST_F(ListTest, TheOverviewKnowsHowLongTheListsAre) {
    const ProgramResult overview = run({"list"}, {.environment = {{"MESA_GL_VERSION_OVERRIDE", "2.1"}, {"DISPLAY", ""}}});
    EXPECT_EQ(overview.status, 0) << overview.shown();
    EXPECT_EQ(overview.err, "") << "a driver was asked";
    const auto rows = rowsOf(overview.out);
    EXPECT_GE(rows.size(), 13u);
    for (const auto& row : rows)
        EXPECT_EQ(row.at(1), std::to_string(rowsOf(succeed({"list", row.at(0)}).out).size())) << row.at(0);
}

TEST_F(ListTest, LimitsKnowSizesAndTheDriver) {
    const auto rows = rowsOf(succeed({"list", "limits"}).out);
    std::map<std::string, std::string> values;
    for (const auto& row : rows)
        values[row.at(0)] = row.at(1);
    EXPECT_EQ(values["picture-side"], "16384");
    EXPECT_EQ(values["picture-samples"], "134217728");
    EXPECT_EQ(values["supersample"], "16");
    // Three quarters of what the machine has (3 bytes more, however they are rounded), or less in a container; enough to draw at all.
    EXPECT_GE(std::stoull(values["memory"]), 100'000'000u);
    EXPECT_LE(std::stoull(values["memory"]),
              static_cast<unsigned long long>(sysconf(_SC_PHYS_PAGES)) * sysconf(_SC_PAGESIZE) / 4 * 3 + 3);
    EXPECT_EQ(values["lights"], "64");
    EXPECT_GE(std::stoi(values["driver-texture-side"]), 1024);
    EXPECT_GE(std::stoi(values["driver-sub-pixel"]), 4); // what OpenGL promises
}

TEST_F(ListTest, LimitsWithoutGraphicsAreThoseOfTheProgram) {
    const ProgramResult result =
        run({"list", "limits"}, {.environment = {{"MESA_GL_VERSION_OVERRIDE", "2.1"}, {"DISPLAY", ""}}});
    EXPECT_EQ(result.status, 0) << result.shown();
    EXPECT_NE(result.out.find("picture-side"), std::string::npos);
    EXPECT_EQ(result.out.find("driver-"), std::string::npos);
    EXPECT_NE(result.err.find("shadowlab: note: "), std::string::npos);
}

TEST_F(ListTest, HelpAndVersion) {
    for (const std::vector<std::string>& arguments : std::vector<std::vector<std::string>>{
             {"--help"}, {"-h"}, {"capture", "--help"}, {"list", "--help"}, {"demo", "-h"}}) {
        const ProgramResult result = succeed(arguments);
        EXPECT_NE(result.out.find("Usage: shadowlab"), std::string::npos) << result.shown();
        EXPECT_EQ(result.err, "");
    }
    std::string capture = succeed({"capture", "--help"}).out;
    // CLI11 breaks lines where it likes, 2.6 also within a description.
    const auto isSameBlank = [](char a, char b) { return a == ' ' && b == ' '; };
    std::ranges::replace(capture, '\n', ' ');
    capture.erase(std::unique(capture.begin(), capture.end(), isSameBlank), capture.end());
    for (const char* part : {"pixels", "DEGREES", "milliseconds", "OUT.png", "default 1280x720", "Examples:"})
        EXPECT_NE(capture.find(part), std::string::npos) << part;
    EXPECT_EQ(succeed({"--version"}).out.substr(0, 10), "shadowlab ");
}

TEST_F(ListTest, NoColourIsNotEvenUsed) {
    for (const auto& environment : {std::map<std::string, std::string>{{"NO_COLOR", "1"}}, {{"CLICOLOR_FORCE", "1"}}}) {
        EXPECT_EQ(run({"--help"}, {.environment = environment}).out.find('\x1b'), std::string::npos);
        EXPECT_EQ(run({"--nonsense"}, {.environment = environment}).err.find('\x1b'), std::string::npos);
    }
}

TEST_F(ListTest, AReaderMayStopReading) {
    // The reader is gone before anything is written: no message, no failure.
    const ProgramResult result = shell("{ sleep 0.3; \"$SHADOWLAB\" list parameters; echo \"status $?\" >&2; } | true");
    EXPECT_EQ(result.err, "status 0\n");
    EXPECT_EQ(shell("\"$SHADOWLAB\" list parameters | head -1").err, "");
}

TEST_F(ListTest, StandardOutputThatCannotBeWritten) {
    expectOneLine(shell("\"$SHADOWLAB\" list scenes >/dev/full"), 4, {"standard output", "no space left"});
    expectOneLine(shell("\"$SHADOWLAB\" list scenes >&-"), 4, {"standard output", "not open for writing"});
    expectOneLine(shell("\"$SHADOWLAB\" --help >/dev/full"), 4, {"standard output"});
    EXPECT_EQ(shell("\"$SHADOWLAB\" list nonsense 2>&-").status, 2);
}

} // namespace
} // namespace shadowlab::testing
