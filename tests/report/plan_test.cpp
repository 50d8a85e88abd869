// The sweeps that techniques declare, and how they are dealt out.
// SPDX-License-Identifier: MIT
#include "app/report/plan.h"

#include <gtest/gtest.h>

#include <set>

#include "app/lab/settings.h"
#include "app/picture/session.h"
#include "app/report/store.h"
#include "techniques/foundation/base/error.h"
#include "techniques/registry.h"

namespace shadowlab::report {
namespace {

scene::Light lightOf(scene::LightType type) {
    scene::Light light;
    light.name = "key";
    light.type = type;
    return light;
}

TEST(ReportPlan, EverySweepOfEveryTechniqueCanBeSet) {
    using enum scene::LightType;
    int tried = 0;
    for (const RegisteredTechnique& registered : registeredTechniques())
        for (const scene::LightType type : {point, directional, spot, rect, sphere})
            for (const bool quick : {true, false}) {
                std::set<std::string> names;
                for (const PointKey& key : pointsOf(*registered.info, lightOf(type), quick)) {
                    EXPECT_TRUE(names.insert(key.name()).second) << "twice: " << key.name();
                    std::vector<picture::Slot> slots;
                    slots.push_back(picture::Session::makeSlot(key.technique));
                    for (const std::string& setting : key.settings)
                        EXPECT_NO_THROW(lab::applySettings(slots, {key.technique + "." + setting})) << key.name();
                    ++tried;
                }
                EXPECT_FALSE(names.empty());
            }
    EXPECT_GE(tried, 200);
}

TEST(ReportPlan, AQuickOneIsAPartOfAFullOne) {
    for (const RegisteredTechnique& registered : registeredTechniques()) {
        const scene::Light light = lightOf(scene::LightType::rect);
        const std::vector<PointKey> quick = pointsOf(*registered.info, light, true),
                                    full = pointsOf(*registered.info, light, false);
        EXPECT_LE(quick.size(), full.size());
        for (const PointKey& key : quick)
            EXPECT_NE(std::ranges::find(full, key), full.end()) << key.name();
    }
}

TEST(ReportPlan, ATechniqueWithoutSweepsHasItsDefaults) {
    TechniqueInfo info;
    info.id = "plain";
    const std::vector<PointKey> points = pointsOf(info, lightOf(scene::LightType::point), false);
    ASSERT_EQ(points.size(), 1u);
    EXPECT_EQ(points[0].name(), "plain");
}

Plan madeUpPlan() {
    Plan plan;
    for (int g = 0; g < 3; ++g) {
        PlannedGroup group{"scene" + std::to_string(g), "scene" + std::to_string(g), "key", "0", {}};
        group.points.push_back({std::string(kYardstick), {}, "", "", 0});
        for (int p = 0; p < 2 + 3 * g; ++p)
            group.points.push_back({"technique" + std::to_string(p), {}, "", "", 0});
        plan.groups.push_back(group);
    }
    return plan;
}

TEST(ReportPlan, ShardsHaveEveryPointOnceAndTheYardstickEach) {
    const Plan plan = madeUpPlan();
    for (int count = 1; count <= 20; ++count) {
        std::multiset<std::string> dealt;
        std::size_t least = 1000, most = 0;
        for (int number = 1; number <= count; ++number) {
            std::size_t own = 0;
            for (const PlannedGroup& group : shardOf(plan, {number, count})) {
                ASSERT_GE(group.points.size(), 2u);
                EXPECT_EQ(group.points.front().technique, kYardstick);
                for (std::size_t i = 1; i < group.points.size(); ++i, ++own)
                    dealt.insert(group.scene + " " + group.points[i].name());
            }
            least = std::min(least, own), most = std::max(most, own);
        }
        EXPECT_EQ(dealt.size(), 15u);
        EXPECT_EQ(std::set<std::string>(dealt.begin(), dealt.end()).size(), 15u);
        EXPECT_LE(most - least, 1u);
    }
}

TEST(ReportPlan, ShardsAreWrittenAsTwoNumbers) {
    EXPECT_EQ(shardFrom("2/5"), (Shard{2, 5}));
    for (const char* wrong : {"", "2", "0/3", "4/3", "1/0", "-1/2", "1/2/3", "a/b", "1/99999", "1 /2", "+1/2"})
        EXPECT_THROW(shardFrom(wrong), Error) << wrong;
}

TEST(ReportStore, FileNamesAreSafeAndDifferent) {
    EXPECT_EQ(fileName("shadow-map filter=hard resolution=512"), "shadow-map_filter=hard_resolution=512");
    std::set<std::string> names;
    const std::vector<std::string> strange = {
        "a/b", "a\\b", "a:b", "a*b", "..", ".", "", "über", "a\nb", std::string(300, 'x'), std::string(301, 'x')};
    for (const std::string& name : strange) {
        const std::string file = fileName(name);
        EXPECT_EQ(file.find_first_of("/\\:*\n"), std::string::npos) << file;
        EXPECT_FALSE(file.starts_with('.')) << file;
        EXPECT_LE(file.size(), 200u);
        names.insert(file);
    }
    EXPECT_EQ(names.size(), strange.size());
}

} // namespace
} // namespace shadowlab::report
