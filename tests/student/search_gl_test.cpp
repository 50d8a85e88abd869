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
        const int rounds = 3;
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
        for (const auto& [idea, count] : fair)
            std::cout << family.id << ": " << count << " of " << rounds << " ask something: " << idea << "\n";
        EXPECT_GE(all, rounds * kinds / 2) << family.id;
    }
}

} // namespace
} // namespace shadowlab::student
