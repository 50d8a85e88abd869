// Which points are worth having, how sweeps grow, and what exactness costs, of made-up groups.
// SPDX-License-Identifier: MIT
#include "app/report/analysis.h"

#include <gtest/gtest.h>

namespace shadowlab::report {
namespace {

Point point(const std::string& technique, double ms, int wrong, double edgeErrorPx) {
    Point made;
    made.key.technique = technique;
    made.errors.falseLit = wrong;
    made.errors.rmse = wrong > 0 ? 0.1 : 0;
    made.errors.edgeErrorPx = edgeErrorPx;
    made.costs.emplace();
    made.costs->frame = {ms, ms, ms, ms};
    made.costs->shadow = {ms - 10, ms - 10, ms - 10, ms - 10};
    return made;
}

std::vector<bool> front(Group& group) {
    markFront(group);
    std::vector<bool> on;
    for (const Point& p : group.points)
        on.push_back(p.onFront);
    return on;
}

TEST(ReportAnalysis, TheFrontIsWhatNothingBeats) {
    Group group;
    group.points = {point("a", 10, 5, 0.5), point("b", 20, 2, 0.2), point("c", 15, 9, 0.9), point("d", 30, 2, 0.2),
                    point("e", 40, 0, 0)};
    EXPECT_EQ(front(group), (std::vector<bool>{true, true, false, false, true}));
}

TEST(ReportAnalysis, EqualPointsAreBothOnIt) {
    Group group;
    group.points = {point("a", 10, 5, 0.5), point("b", 10, 5, 0.5)};
    EXPECT_EQ(front(group), (std::vector<bool>{true, true}));
}

TEST(ReportAnalysis, TheYardstickAndWhatServesAPartDoNotCompete) {
    Group group;
    group.points = {point("unshadowed", 1, 0, 0), point("planar", 2, 0, 0), point("c", 15, 9, 0.9),
                    point("d", 30, 2, 0.2)};
    group.points[0].isYardstick = true;
    group.points[1].errors.served = 0.9;
    group.points[3].costs.reset(); // not measured yet
    EXPECT_EQ(front(group), (std::vector<bool>{false, false, true, false}));
}

TEST(ReportAnalysis, SweepsGrowByTheirPowers) {
    Group group;
    for (const double side : {256.0, 512.0, 1024.0}) {
        group.points.push_back(point("shadow-map", side * side / 1e4, 3, 100 / side));
        group.points.back().key.sweep = "Hard map";
        group.points.back().key.varies = "resolution";
        group.points.back().key.value = side;
    }
    group.points.push_back(point("ray-traced", 50, 0, 0)); // of no sweep
    const std::vector<Growth> growth = growthOf(group);
    ASSERT_EQ(growth.size(), 1u);
    EXPECT_NEAR(growth[0].costPower, 2, 1e-9);
    ASSERT_TRUE(growth[0].errorPower);
    EXPECT_NEAR(*growth[0].errorPower, -1, 1e-9);
    EXPECT_EQ(growth[0].from, 256);
    EXPECT_EQ(growth[0].to, 1024);
}

TEST(ReportAnalysis, ExactnessCostsWhatTheCheapestOfEachKindCost) {
    Group group;
    group.points = {point("cheap", 20, 5, 0.5), point("exact", 50, 0, 0), point("dearer", 60, 0, 0),
                    point("wrong", 30, 5, 0.5)};
    group.points[1].costs->passes = {{"volumes", 30}, {"light", 10}};
    group.points[1].errors.counters = {{"volumes", "casters", 3, 12}};
    const ExactAgainstInexact exactness = exactnessOf(group);
    EXPECT_EQ(exactness.exact, 1u);
    EXPECT_EQ(exactness.inexact, 0u);
    EXPECT_DOUBLE_EQ(exactness.frameRatio, 2.5);
    EXPECT_DOUBLE_EQ(exactness.shadowRatio, 4);
    EXPECT_NE(exactness.why.find("volumes 75 %"), std::string::npos) << exactness.why;
    EXPECT_NE(exactness.why.find("volumes 3 of 12"), std::string::npos) << exactness.why;
}

TEST(ReportAnalysis, WithinTwiceThereIsNothingToExplain) {
    Group group;
    group.points = {point("cheap", 20, 5, 0.5), point("exact", 39, 0, 0)};
    EXPECT_EQ(exactnessOf(group).why, "");
    group.points.pop_back();
    EXPECT_FALSE(exactnessOf(group).exact);
}

} // namespace
} // namespace shadowlab::report
