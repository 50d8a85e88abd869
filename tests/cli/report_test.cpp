// `report` as a user meets it: what it writes, that its parts make the whole, that it goes on where it was stopped, refusals.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <chrono>
#include <csignal>
#include <thread>

#include <nlohmann/json.hpp>

#include "tests/cli/command_fixture.h"

namespace shadowlab::testing {
namespace {

using Json = nlohmann::ordered_json;

class ReportTest : public CommandTest {
protected:
    /// A small one: eight points.
    [[nodiscard]] std::vector<std::string> small(const std::string& output,
                                                 const std::vector<std::string>& more = {}) const {
        std::vector<std::string> words{
            "report", "box.json", "-t", "shadow-map,shadow-volume-zfail", "--quick", "--size", "128x96", "-o", output};
        words.insert(words.end(), more.begin(), more.end());
        return words;
    }
    [[nodiscard]] Json json(const std::string& output) const {
        return Json::parse(fileContent(folder.path() / output / "report.json"));
    }
    /// What does not depend on times.
    static Json withoutTimes(Json report) {
        report.erase("machines");
        report.erase("rounds");
        for (Json& group : report.at("groups")) {
            group.erase("growth");
            group.erase("exactness");
            for (Json& point : group.at("points")) {
                point.erase("costs");
                point.erase("onFront");
            }
        }
        return report;
    }
};

TEST_F(ReportTest, WritesEveryPointWithCostAndErrorAndHowToRepeatIt) {
    const ProgramResult result = succeed(small("out"));
    EXPECT_EQ(result.out, "out/index.html\n");
    EXPECT_EQ(result.err, "") << "nobody sits at a terminal";
    for (const char* file : {"index.html", "points.csv", "report.json", "plan.json", "charts/box@key.svg"})
        EXPECT_GT(fileContent(folder.path() / "out" / file).size(), 0u) << file;

    const Json report = json("out");
    ASSERT_EQ(report.at("groups").size(), 1u);
    EXPECT_GT(report.at("machines").at(0).at("cores"), 0);
    const Json& points = report.at("groups")[0].at("points");
    EXPECT_EQ(points.size(), 6u);
    int wrong = 0, onFront = 0;
    for (const Json& point : points) {
        const Json& errors = point.at("errors");
        EXPECT_GT(errors.at("lit"), 500);
        EXPECT_GT(errors.at("shadowed"), 100);
        wrong += errors.at("falseLit").get<int>() + errors.at("falseShadow").get<int>();
        onFront += point.at("onFront").get<bool>();
        const Json& costs = point.at("costs");
        EXPECT_GE(costs.at("frames"), 3);
        const double median = costs.at("frameMs").at("median");
        EXPECT_GT(median, 0);
        EXPECT_LE(costs.at("frameMs").at("lower"), median);
        EXPECT_GE(costs.at("frameMs").at("upper"), median);
        EXPECT_FALSE(costs.at("passMs").empty());
    }
    EXPECT_GT(wrong, 100) << "of the picture without shadows alone";
    EXPECT_GE(onFront, 1);
    const std::string csv = fileContent(folder.path() / "out" / "points.csv");
    EXPECT_EQ(std::ranges::count(csv, '\n'), 7);

    // The command that stands beside a point measures the same errors; of its frames the first is enough.
    const std::string command = points.at(1).at("command");
    ASSERT_EQ(command.find("shadowlab measure "), 0u);
    const std::size_t words = std::string("shadowlab").size();
    const ProgramResult again =
        shell("$SHADOWLAB" + command.substr(words, command.find(" --frames") - words) + " --json");
    ASSERT_EQ(again.status, 0) << again.shown();
    const Json measured = Json::parse(again.out).at("results")[0];
    for (const char* key : {"falseLit", "falseShadow", "coreErrors", "ties", "lit", "shadowed", "rmse", "edgeErrorPx"})
        EXPECT_EQ(measured.at(key), points[1].at("errors").at(key)) << key;
}

TEST_F(ReportTest, ItsPartsMakeTheWhole) {
    succeed(small("whole"));
    for (const char* part : {"1", "2", "3"})
        succeed(small(std::string("part-") + part, {"--shard", std::string(part) + "/3"}));
    // One alone is no whole.
    const ProgramResult early = run({"report", "merge", "part-1", "part-3", "-o", "early"});
    expectOneLine(early, 3, {"points that are in none of the parts"});
    EXPECT_FALSE(std::filesystem::exists(folder.path() / "early"));
    succeed({"report", "merge", "part-1", "part-2", "part-3", "-o", "merged"});
    EXPECT_EQ(withoutTimes(json("merged")).dump(1), withoutTimes(json("whole")).dump(1));
    const Json merged = json("merged");
    for (const Json& point : merged.at("groups")[0].at("points"))
        EXPECT_GT(point.at("costs").at("frameMs").at("median"), 0) << "measured by its shard";
    EXPECT_EQ(json("merged").at("machines").size(), 3u);
    // Pictures, too, byte for byte.
    int compared = 0;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder.path() / "whole" / "parts"))
        if (entry.path().extension() == ".png") {
            const auto relative = entry.path().lexically_relative(folder.path() / "whole");
            EXPECT_EQ(fileContent(entry.path()), fileContent(folder.path() / "merged" / relative)) << relative;
            ++compared;
        }
    EXPECT_EQ(compared, 12);
    // A part that is damaged is named where it lies, before anything of the others is taken over.
    int named = 0;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder.path() / "part-2" / "parts"))
        if (entry.is_regular_file()) { // pictures, too
            const std::string file = entry.path().lexically_relative(folder.path()).string();
            const std::string whole = fileContent(entry.path());
            folder.write(file, whole.substr(0, whole.size() / 2));
            expectOneLine(run({"report", "merge", "part-1", "part-2", "part-3", "-o", "damaged"}), 3, {file + ": "});
            EXPECT_FALSE(std::filesystem::exists(folder.path() / "damaged"));
            folder.write(file, whole);
            ++named;
        }
    EXPECT_GE(named, 4);
}

TEST_F(ReportTest, GoesOnWhereItWasStopped) {
    const std::filesystem::path parts = folder.path() / "out" / "parts" / "box@key";
    const auto known = [&] {
        std::map<std::string, std::filesystem::file_time_type> points;
        std::error_code error;
        for (const auto& entry : std::filesystem::directory_iterator(parts, error))
            if (entry.path().extension() == ".json") points[entry.path().filename()] = entry.last_write_time();
        return points;
    };
    std::vector<std::string> argv = small("out");
    argv.insert(argv.begin(), SHADOWLAB_PROGRAM);
    ProgramSetting setting;
    setting.folder = folder.path();
    RunningProgram program(argv, setting);
    while (known().size() < 3 && !program.hasEnded())
        std::this_thread::sleep_for(std::chrono::milliseconds(2));
    program.signal(SIGINT);
    EXPECT_EQ(program.wait().status, 130);
    const auto before = known();
    ASSERT_GE(before.size(), 3u);
    EXPECT_FALSE(std::filesystem::exists(folder.path() / "out" / "report.json"));
    for (const auto& [name, content] : listing())
        EXPECT_EQ(name.find(".tmp."), std::string::npos) << name;

    succeed(small("out"));
    for (const auto& [name, time] : known())
        if (before.contains(name) && !name.starts_with("times")) {
            EXPECT_EQ(time, before.at(name)) << name << " was judged twice";
        }
    succeed(small("uninterrupted"));
    EXPECT_EQ(withoutTimes(json("out")).dump(1), withoutTimes(json("uninterrupted")).dump(1));

    // A third time there is nothing left to do, and nothing changes.
    const std::string first = fileContent(folder.path() / "out" / "report.json");
    const ProgramResult again = run(small("out"));
    expectOneLine(again, 0, {"measured before"});
    EXPECT_EQ(fileContent(folder.path() / "out" / "report.json"), first);
    // Pictures that are lost are drawn again, and the same.
    const std::string page = fileContent(folder.path() / "out" / "index.html");
    int lost = 0;
    for (const auto& entry : std::filesystem::directory_iterator(parts))
        lost += entry.path().extension() == ".png" && std::filesystem::remove(entry.path()) ? 1 : 0;
    EXPECT_GE(lost, 10);
    succeed(small("out"));
    EXPECT_EQ(fileContent(folder.path() / "out" / "index.html"), page);
    expectOneLine(run(small("out", {"--light", "sun"})), 3, {"plan.json", "other scenes, techniques or lights"});
}

TEST_F(ReportTest, HardCasesAreATableOfTheirOwn) {
    // Seventy scenes take a minute, beside other tests two; who takes ten has stopped.
    succeed({"report", "--hard", "--quick", "-o", "hard"}, {.timeoutSeconds = 600}); // else 1
    const Json hard = Json::parse(fileContent(folder.path() / "hard" / "hard.json"));
    int checks = 0, caught = 0;
    for (const Json& one : hard.at("cases"))
        for (const Json& check : one.at("checks")) {
            EXPECT_EQ(check.at("verdict"), "right") << one.at("case");
            caught += check.at("caught") == true;
            ++checks;
        }
    EXPECT_GE(hard.at("cases").size(), 70u);
    EXPECT_GE(checks, 50);
    EXPECT_GE(caught, 30);
    const std::string csv = fileContent(folder.path() / "hard" / "hard.csv");
    EXPECT_GT(std::ranges::count(csv, '\n'), 100);
    EXPECT_NE(fileContent(folder.path() / "hard" / "hard.html").find("</html>"), std::string::npos);
}

TEST_F(ReportTest, Refusals) {
    expectRefused({"report"}, 2, {"--output"});
    expectRefused({"report", "no-such-scene", "-o", "out"}, 3, {"no-such-scene"});
    for (const char* shard : {"0/3", "4/3", "1/0", "x", "1/2/3"})
        expectRefused({"report", "box.json", "-o", "out", "--shard", shard}, 2, {"--shard", shard});
    expectRefused({"report", "box.json", "-o", "out", "-t", "shadow-mop"}, 2, {"shadow-map"});
    expectRefused({"report", "box.json", "-o", "out", "--light", "moon"}, 2, {"moon"});
    expectRefused({"report", "box.json", "box.json", "-o", "out"}, 2, {"'box'"});
    expectRefused({"report", "merge", "-o", "out"}, 2, {"merge"});
    expectRefused({"report", "merge", ".", "-o", "out"}, 3, {"plan.json"});
    expectRefused({"report", "merge", "a", "--quick", "-o", "out"}, 2, {"--quick"});
    expectRefused({"report", "box.json", "--hard", "-o", "out"}, 2, {"--hard"});
    folder.write("file", "no folder");
    expectRefused({"report", "box.json", "-o", "file"}, 4, {"file"});
    std::filesystem::create_directory(folder.path() / "foreign");
    folder.write("foreign/index.html", "somebody's page");
    expectRefused({"report", "box.json", "-o", "foreign"}, 4, {"foreign/index.html", "-o"});
    expectRefused({"report", "merge", "foreign", "-o", "foreign"}, 2, {"one of the parts"});
    std::filesystem::create_directories(folder.path() / "foreign" / "parts");
    for (const char* name : {"foreign/hard.html", "foreign/hard.json", "foreign/parts/P1.json"}) {
        folder.write(name, "[\"somebody's own\"]");
        expectRefused({"report", "--hard", "-o", "foreign"}, 4, {name, "-o"});
        EXPECT_EQ(fileContent(folder.path() / name), "[\"somebody's own\"]");
        std::filesystem::remove(folder.path() / name);
    }
    folder.write("plan.json", "{");
    expectRefused({"report", "merge", ".", "-o", "out"}, 3, {"plan.json"});
}

} // namespace
} // namespace shadowlab::testing
