// What is kept in a report's folder comes back as it was, and what is no part of a report is refused by name.
// SPDX-License-Identifier: MIT
#include "app/report/store.h"

#include <gtest/gtest.h>

#include <fstream>

#include "app/report/assemble.h"
#include "app/report/json_parts.h"
#include "techniques/foundation/base/error.h"
#include "tests/foundation/scene/scene_files.h"

namespace shadowlab::report {
namespace {

PlannedGroup madeUpGroup() {
    return {"room \"x\".json",
            "room, \"x\"",
            "key",
            "0123456789abcdef",
            {{"unshadowed", {}, "", "", 0},
             {"shadow-map", {"filter=hard", "resolution=512"}, "Hard map", "resolution", 512}}};
}

Plan madeUpPlan() { return {"0.1", "a build", {64, 48}, true, "renderer", {}, {madeUpGroup()}}; }

Judge::Judged madeUpErrors(int wrong) {
    Judge::Judged judged;
    judged.errors.pixels = 3000, judged.errors.lit = 2000, judged.errors.shadowed = 1000;
    judged.errors.falseLit = wrong;
    judged.errors.rmse = 1.0 / 3;
    judged.errors.edgeErrorPx = 0.1 + 0.2; // no decimal fraction: every digit has to come back
    judged.errors.counters = {{"casters", "objects", 3, 12}};
    judged.picturePng = {1, 2, 0, 255};
    judged.errorPng = {4};
    return judged;
}

Times madeUpTimes() {
    Times times;
    times.rounds.push_back({{"unshadowed", {{10, 11}, {0, 0}, {9, 10}, {1, 1}, {9}, {{"light", 5.5}}}},
                            {"shadow-map filter=hard resolution=512", {{20}, {1}, {18}, {1}, {12}, {{"depth", 3}}}}});
    times.firstMs = {{"unshadowed", 50}};
    times.residentMegabytes = {{"unshadowed", 1.5}};
    return times;
}

class ReportStoreTest : public ::testing::Test {
protected:
    scene::TempFolder folder;
    Store store{folder.path() / "a"};
};

TEST_F(ReportStoreTest, EveryDigitComesBack) {
    const Plan plan = madeUpPlan();
    store.begin(plan);
    EXPECT_EQ(store.plan(), plan);
    EXPECT_FALSE(store.judged(plan.groups[0], plan.groups[0].points[1]));
    store.keep(plan.groups[0], plan.groups[0].points[1], madeUpErrors(7));
    const auto judged = store.judged(plan.groups[0], plan.groups[0].points[1]);
    ASSERT_TRUE(judged);
    EXPECT_EQ(toJson(judged->errors), toJson(madeUpErrors(7).errors));
    EXPECT_EQ(judged->errors.edgeErrorPx, 0.1 + 0.2);
    EXPECT_EQ(judged->picturePng, madeUpErrors(7).picturePng);
    store.keep(plan.groups[0], {1, 1}, madeUpTimes());
    EXPECT_EQ(toJson(store.times(plan.groups[0], {1, 1})), toJson(madeUpTimes()));
    EXPECT_TRUE(store.times(plan.groups[0], {2, 3}).rounds.empty());
}

TEST_F(ReportStoreTest, AnotherReportIsRefusedAndSaysWhatIsOther) {
    store.begin(madeUpPlan());
    store.begin(madeUpPlan()); // the same goes on
    const auto refusal = [&](const Plan& other) -> std::string {
        try {
            store.begin(other);
        } catch (const Error& error) {
            EXPECT_EQ(error.status(), ExitStatus::badInput);
            return error.what();
        }
        return "none";
    };
    Plan other = madeUpPlan();
    other.size.x = 65;
    EXPECT_NE(refusal(other).find("64x48, not 65x48"), std::string::npos) << refusal(other);
    other = madeUpPlan();
    other.build = "with an edited shader";
    EXPECT_NE(refusal(other).find("shaders"), std::string::npos) << refusal(other);
    other = madeUpPlan();
    other.furtherWords = {"--backend", "osmesa"};
    EXPECT_NE(refusal(other).find("--backend"), std::string::npos) << refusal(other);
    other = madeUpPlan();
    other.groups[0].digest = "another scene";
    EXPECT_NE(refusal(other).find("other scenes"), std::string::npos) << refusal(other);
}

TEST_F(ReportStoreTest, APointWhosePicturesAreNotAsTheyWereIsUnknown) {
    const Plan plan = madeUpPlan();
    const PointKey& point = plan.groups[0].points[1];
    store.begin(plan);
    int damaged = 0;
    store.keep(plan.groups[0], point, madeUpErrors(7));
    for (const auto& entry : std::filesystem::recursive_directory_iterator(store.folder() / "parts")) {
        if (entry.path().extension() != ".png") continue;
        std::ofstream(entry.path()) << "another picture";
        EXPECT_FALSE(store.judged(plan.groups[0], point)) << entry.path();
        store.keep(plan.groups[0], point, madeUpErrors(7));
        EXPECT_TRUE(store.judged(plan.groups[0], point)) << entry.path();
        ++damaged;
    }
    EXPECT_EQ(damaged, 2);
}

TEST_F(ReportStoreTest, WhatIsNoPartOfAReportIsNamed) {
    store.begin(madeUpPlan());
    const auto path = folder.path() / "a" / "plan.json";
    for (const char* text : {"", "{", "[]", "{\"program\": 3}", "null"}) {
        std::ofstream(path) << text;
        EXPECT_THROW((void)store.plan(), Error) << text;
    }
    EXPECT_THROW((void)Store(folder.path() / "none").plan(), Error);
}

TEST_F(ReportStoreTest, NumbersThatCannotBeAreRefused) {
    const Plan plan = madeUpPlan();
    const PointKey& point = plan.groups[0].points[1];
    const Json whole = toJson(madeUpErrors(7).errors);
    EXPECT_NO_THROW(static_cast<void>(errorsFromJson(whole)));
    int refused = 0;
    const std::vector<std::pair<const char*, Json>> changes{
        {"lit", -2000},   {"lit", 2001},    {"lit", 1e300},     {"pixels", 3000.5},    {"shadowed", 4294967296 + 1000},
        {"ties", "none"}, {"falseLit", -1}, {"falseLit", 1001}, {"falseShadow", 2001}, {"coreErrors", 8},
        {"served", 1.5},  {"served", -0.5}, {"rmse", -1},       {"edgeErrorPx", -0.1}, {"glMegabytes", -3},
        {"rmse", "many"}, {"converged", 2}};
    for (const auto& [member, value] : changes) {
        Json part = whole;
        part[member] = value;
        part["pictures"] = {"0", "0"};
        store.begin(plan);
        store.keep(plan.groups[0], point, madeUpErrors(7));
        for (const auto& entry : std::filesystem::recursive_directory_iterator(store.folder() / "parts"))
            if (entry.path().extension() == ".json") std::ofstream(entry.path()) << part;
        try {
            static_cast<void>(store.judged(plan.groups[0], point));
            ADD_FAILURE() << member << " " << value;
        } catch (const Error& error) {
            EXPECT_EQ(error.status(), ExitStatus::badInput);
            EXPECT_NE(std::string(error.what()).find(".json: is no part"), std::string::npos) << error.what();
            ++refused;
        }
    }
    EXPECT_EQ(refused, 17);
    Json times = toJson(madeUpTimes());
    EXPECT_NO_THROW(static_cast<void>(timesFromJson(times)));
    times["rounds"][0]["unshadowed"]["frame"][1] = -11;
    EXPECT_THROW(static_cast<void>(timesFromJson(times)), std::domain_error);
}

TEST_F(ReportStoreTest, PartsOfAGroupThatIsNotInThePlanAreNotTakenOver) {
    const Plan plan = madeUpPlan();
    store.begin(plan);
    store.keep(plan.groups[0], plan.groups[0].points[1], madeUpErrors(7));
    folder.write("a/parts/another@light/point.json", "{}");
    const Store merged(folder.path() / "merged");
    merged.begin(plan);
    merged.takeOver(store);
    EXPECT_TRUE(merged.judged(plan.groups[0], plan.groups[0].points[1]));
    EXPECT_FALSE(std::filesystem::exists(folder.path() / "merged/parts/another@light"));
}

TEST_F(ReportStoreTest, PartsThatDisagreeAreNotMerged) {
    const Plan plan = madeUpPlan();
    const Store other(folder.path() / "b");
    for (const Store* each : {static_cast<const Store*>(&store), &other}) {
        each->begin(plan);
        each->keep(plan.groups[0], plan.groups[0].points[0], madeUpErrors(1));
    }
    store.takeOver(other); // the same
    EXPECT_EQ(missingPoints({&store, 1}, plan).size(), 1u);
    other.keep(plan.groups[0], plan.groups[0].points[0], madeUpErrors(2));
    EXPECT_THROW(store.takeOver(other), Error);
    EXPECT_EQ(store.judged(plan.groups[0], plan.groups[0].points[0])->errors.falseLit, 1);
}

TEST_F(ReportStoreTest, TheReportFollowsFromThePartsAlone) {
    const Plan plan = madeUpPlan();
    store.begin(plan);
    store.keep(Shard{}, Machine{});
    for (std::size_t i = 0; i < 2; ++i)
        store.keep(plan.groups[0], plan.groups[0].points[i], madeUpErrors(100 - 50 * static_cast<int>(i)));
    store.keep(plan.groups[0], Shard{}, madeUpTimes());
    const Report report = assemble(store);
    ASSERT_EQ(report.groups.size(), 1u);
    const Point& map = report.groups[0].points.at(1);
    ASSERT_TRUE(map.costs);
    EXPECT_EQ(map.costs->frame.median, 20);
    EXPECT_EQ(map.costs->shadow.median, 20 - 10.5); // of one round: less the yardstick's median
    EXPECT_TRUE(map.onFront);
    EXPECT_TRUE(report.groups[0].points[0].isYardstick);
    EXPECT_EQ(map.command, "shadowlab measure 'room \"x\".json' -t shadow-map --set shadow-map.filter=hard --set "
                           "shadow-map.resolution=512 --light key --size 64x48 --frames 30 --orbit-light 30");
    const std::string csv = reportCsv(report);
    EXPECT_NE(csv.find("\"room, \"\"x\"\"\",key,centre,shadow-map,filter=hard resolution=512,Hard map,3000,"),
              std::string::npos)
        << csv;
    EXPECT_EQ(Json::parse(reportJson(report)).at("groups").at(0).at("points").size(), 2u);
}

} // namespace
} // namespace shadowlab::report
