// Random scenes that are hard for a family, tried and made small. What is tried are techniques of the program, drawn in a process of
// their own as those of plug-ins are.
// SPDX-License-Identifier: MIT
#include <map>

#include "app/student/search/finding_files.h"
#include "app/student/search/random_scenes.h"
#include "app/student/search/search.h"
#include "tests/support/gl_fixture.h"

namespace shadowlab::student {
namespace {

class SearchTest : public testing::GlTest {
protected:
    Conditions conditions_{{}, Sandbox(SandboxWanted::none, SHADOWLAB_PROGRAM)};

    SceneTrials trialsOf(const std::string& technique, const std::string& family) {
        return {Candidate{"", technique, "osmesa"}, findFamily(family), conditions_};
    }
};

TEST_F(SearchTest, ScenesAskSomethingAndARightTechniqueIsRight) {
    for (const Family& family : families()) {
        SceneTrials trials = trialsOf(std::string(rightTechnique(family)), std::string(family.id));
        const auto kinds = static_cast<int>(kindsOf(family).size());
        const int rounds = 6; // as many of each as a search of sixty scenes has, where a family has ten kinds
        std::map<std::string_view, int> fair;
        int all = 0;
        for (int number = 0; number < rounds * kinds; ++number) {
            const SceneKind& kind = kindOf(family, number);
            const Trial trial = trials.tryScene(randomScene(family, 7, number), kind.judged);
            fair[kind.idea] += trial.isFair;
            all += trial.isFair;
            EXPECT_EQ(trial.failure, "") << family.id << ": " << kind.idea;
            EXPECT_EQ(trial.wrong, 0) << family.id << ": " << kind.idea;
        }
        for (const auto& [idea, count] : fair) {
            EXPECT_GE(count, 1) << "a kind that asks nothing in a whole search is of no use; " << family.id << ": " << idea;
            std::cout << family.id << ": " << count << " of " << rounds << " ask something: " << idea << "\n";
        }
        ASSERT_EQ(static_cast<int>(fair.size()), kinds);
        EXPECT_GE(all, rounds * kinds / 2) << family.id << ": with less, a search of sixty scenes would ask fewer than thirty times";
    }
}

// The program's technique without shadows is wrong wherever there is one.
TEST_F(SearchTest, ATechniqueWithoutShadowsIsFoundAndTheSceneMadeSmall) {
    for (const char* family : {"planar", "shadow-map", "shadow-volume"}) {
        SceneTrials trials = trialsOf("unshadowed", family);
        SearchPlan plan;
        plan.time = std::chrono::seconds(600); // whatever else the machine does
        const SearchResult result = search(trials, plan, [](int) {});
        ASSERT_TRUE(result.finding) << family;
        const Finding& finding = *result.finding;
        EXPECT_LE(finding.number, 3) << family << ": half of all scenes are fair, and in each of these it is wrong";
        EXPECT_TRUE(finding.isFresh);
        EXPECT_GE(triangleCount(finding.scene), 2) << family << ": one that casts, and one that it casts on";
        // A triangle that casts, and a floor of one or two. The lecture's volumes are right of closed bodies alone, and the smallest of these is
        // a tetrahedron.
        EXPECT_LE(triangleCount(finding.scene), family == std::string("shadow-volume") ? 6 : 3) << family << ": of " << finding.trianglesBefore;
        EXPECT_EQ(finding.trial.falseShadow, 0);
        EXPECT_NE(finding.trial.object, "") << family;
        // As many as a fair scene has of each (scene_trial.cpp).
        EXPECT_GE(finding.trial.lit, 100) << "something is lit";
        EXPECT_GE(finding.trial.shadowed, 100) << "and something is in shadow";
        const std::string sentence = sentenceOf(finding);
        std::cout << family << ": " << sentence << "\n";
        EXPECT_TRUE(sentence.find("here your shadow is missing") != std::string::npos ||
                    sentence.find("pixels are lit that should be in shadow") != std::string::npos)
            << sentence;
        const auto files = filesOf(finding, trials, {"x.so", "unshadowed", "osmesa"}, "found");
        for (const char* name : {"found.json", "found.png", "found.svg", "found-lesson.json"})
            EXPECT_TRUE(files.contains(name)) << family << ": " << name;
        // Another plan has other scenes; the same has the same.
        SceneTrials again = trialsOf("unshadowed", family);
        const SearchResult same = search(again, plan, [](int) {});
        ASSERT_TRUE(same.finding);
        EXPECT_EQ(filesOf(same.finding->scene, "s", ""), filesOf(finding.scene, "s", "")) << family;
    }
}

// A process that ends at once is a failure of every scene, and of a scene that nothing can be taken away from.
TEST_F(SearchTest, WhatDrawsNothingFails) {
    SceneTrials trials = trialsOf("no-such-technique", "planar");
    const Trial trial = trials.tryScene(randomScene(findFamily("planar"), 1, 2), Judged::visibility);
    EXPECT_TRUE(trial.isFair);
    EXPECT_NE(trial.failure.find("no-such-technique"), std::string::npos) << trial.failure;
    EXPECT_TRUE(trial.fails(leastWrong(findFamily("planar"), Judged::visibility)));
}

} // namespace
} // namespace shadowlab::student
