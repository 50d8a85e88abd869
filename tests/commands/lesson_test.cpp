// `shadowlab lesson`: pictures and numbers of lessons, and what is refused.
// SPDX-License-Identifier: MIT
#include <nlohmann/json.hpp>

#include "tests/commands/command_fixture.h"

namespace shadowlab {
namespace {

using testing::ProgramResult;

class LessonCommandTest : public testing::CommandTest {
protected:
    LessonCommandTest() { folder.write("own.json", lesson("5")); }

    /// A lesson about the folder's own scene.
    static std::string lesson(const std::string& atLeast) {
        return R"({"title": "Own", "scene": "box.json", "slots": [{"technique": "shadow-map"}],
            "set": ["shadow-map.resolution=64", "shadow-map.filter=hard"],
            "before": {"set": ["shadow-map.bias-mode=none"]}, "after": {"set": ["shadow-map.exact=true"]},
            "happens": "Stripes.", "mends": "A bias.", "look": [{"box": [0.1, 0.1, 0.2, 0.2], "label": "here"}],
            "expect": [{"quantity": "falseShadow", "before": {"atLeast": )" +
               atLeast + R"(}, "after": {"atMost": 0}}]})";
    }
};

TEST_F(LessonCommandTest, NumbersStandBesideWhatTheyHaveToBe) {
    const ProgramResult table = succeed({"lesson", "own.json"});
    for (const char* part : {"Own, 320 x 180 pixels", "falseShadow", "at least 5", "at most 0", "as expected"})
        EXPECT_NE(table.out.find(part), std::string::npos) << part << "\n" << table.out;
    const nlohmann::json json = nlohmann::json::parse(succeed({"lesson", "own.json", "--json"}).out);
    EXPECT_TRUE(json["asExpected"]);
    EXPECT_GE(json["expectations"][0]["before"]["value"], 5);
    EXPECT_LE(json["expectations"][0]["after"]["value"], 0);
    EXPECT_GT(json["expectations"][0]["before"]["compared"], 10000);
}

TEST_F(LessonCommandTest, ALessonThatDoesNotHoldFails) {
    folder.write("false.json", lesson("1e6"));
    const ProgramResult result = run({"lesson", "false.json"});
    expectOneLine(result, 3, {"false.json", "not as the lesson says"});
    EXPECT_NE(result.out.find("NOT as expected"), std::string::npos) << result.out;
}

TEST_F(LessonCommandTest, PicturesAreOfTheAskedSizeAndTheSameAgain) {
    for (const std::string state : {"before", "after", "both"}) {
        for (const std::string name : {"a.png", "b.png"})
            succeed({"lesson", "own.json", "-o", name, "--state", state, "--size", "640x360"});
        const std::string a = testing::fileContent(folder.path() / "a.png");
        EXPECT_EQ(a, testing::fileContent(folder.path() / "b.png"));
        EXPECT_EQ(testing::headerOf(a).width, 640u);
        EXPECT_EQ(testing::headerOf(a).height, 360u);
    }
}

TEST_F(LessonCommandTest, WhatIsWrongIsSaidInOneLine) {
    expectRefused({"lesson"}, 2, {"LESSON"});
    expectRefused({"lesson", "acna"}, 3, {"acna", "acne"});
    expectRefused({"lesson", "none.json"}, 3, {"none.json"});
    expectRefused({"lesson", "box.json"}, 3, {"box.json:1:"});
    expectRefused({"lesson", "own.json", "-o", "x.jpg"}, 2, {"x.jpg"});
    expectRefused({"lesson", "own.json", "-o", "x.png", "--state", "between"}, 2, {"between", "both"});
    expectRefused({"lesson", "own.json", "-o", "x.png", "--size", "200x90"}, 2, {"200x90", "larger"});
    expectRefused({"lesson", "own.json", "--state", "after"}, 2, {"--state", "-o"});
    expectRefused({"lesson", "own.json", "-o", "x.png", "--json"}, 2, {"--json", "--measure"});
    expectRefused({"lesson", "own.json", "-o", "nowhere/x.png"}, 4, {"nowhere"});
}

TEST_F(LessonCommandTest, WithoutADisplayTheDemoWritesTheLesson) {
    const ProgramResult result =
        succeed({"demo", "--lesson", "own.json"}, {.environment = {{"DISPLAY", ""}, {"WAYLAND_DISPLAY", ""}}});
    EXPECT_NE(result.out.find("own-lesson.png"), std::string::npos) << result.shown();
    EXPECT_EQ(testing::headerOf(testing::fileContent(folder.path() / "own-lesson.png")).width, 1600u);
}

} // namespace
} // namespace shadowlab
