// `shadowlab lesson`: pictures and numbers of lessons, and what is refused.
// SPDX-License-Identifier: MIT
#include <nlohmann/json.hpp>

#include <sys/stat.h>

#include "tests/cli/command_fixture.h"
#include "tests/support/apng_reader.h"

namespace shadowlab {
namespace {

using testing::ProgramResult;

class LessonCommandTest : public testing::CommandTest {
protected:
    LessonCommandTest() { folder.write("own.json", lesson("5")); }

    /// A lesson about the folder's own scene.
    static std::string lesson(const std::string& atLeast) {
        return R"({"title": "Own", "scene": "box.json", "slots": [{"technique": "shadow-map"}],
            "before": {"set": ["shadow-map.resolution=64", "shadow-map.filter=hard", "shadow-map.bias-mode=none"]},
            "after": {"slots": [{"technique": "shadow-map-exact"}], "set": ["shadow-map-exact.resolution=64"]},
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
    expectRefused({"lesson", "own.json", "--animate"}, 2, {"--animate", "-o"});
    expectRefused({"lesson", "own.json", "-o", "x.mp4"}, 2, {"x.mp4", "--animate"});
    expectRefused({"lesson", "own.json", "-o", "x.png", "--hold", "3"}, 2, {"--hold", "--animate"});
    expectRefused({"lesson", "own.json", "--animate", "-o", "x.png", "--hold", "0"}, 2, {"--hold", "0.01"});
    expectRefused({"lesson", "own.json", "--animate", "-o", "x.png", "--state", "after"}, 2, {"--state"});
    expectRefused({"lesson", "own.json", "--animate", "-o", "x.png", "--size", "200x90"}, 2, {"200x90", "larger"});
    expectRefused({"lesson", "own.json", "--animate", "-o", "nowhere/x.mp4"}, 4, {"nowhere"});
    expectRefused({"lesson", "own.json", "--animate", "-o", "x.mp4"}, 4, {"ffmpeg", "package"},
                  {.environment = {{"PATH", folder.path().string()}}});
}

TEST_F(LessonCommandTest, AnAnimationShowsTheArtefactAndThenTheMend) {
    for (const std::string name : {"a.png", "b.png"})
        succeed({"lesson", "own.json", "--animate", "-o", name, "--size", "320x180"});
    const std::string a = testing::fileContent(folder.path() / "a.png");
    EXPECT_EQ(a, testing::fileContent(folder.path() / "b.png"));
    const testing::Apng film = testing::readApng({a.begin(), a.end()});
    ASSERT_EQ(film.frames.size(), 2u);
    EXPECT_EQ(ivec2(film.width, film.height), ivec2(320, 180));
    EXPECT_NE(film.frames[0].shown, film.frames[1].shown);
    // Four seconds, and of words that are read at 160 a minute "Stripes." with the label "here", and "A bias.": 4.75 s each.
    for (const testing::ApngFrame& frame : film.frames) {
        EXPECT_EQ(frame.delayNumerator, 48u);
        EXPECT_EQ(frame.delayDenominator, 10u);
    }
    succeed({"lesson", "own.json", "--animate", "-o", "held.png", "--size", "320x180", "--hold", "1.5"});
    const std::string held = testing::fileContent(folder.path() / "held.png");
    EXPECT_EQ(testing::readApng({held.begin(), held.end()}).frames[1].delayNumerator, 15u);
}

TEST_F(LessonCommandTest, AnAnimationAsksAndAnswersFirst) {
    const auto shots = [&](const std::string& question) {
        std::string text = lesson("5");
        text.insert(text.rfind('}'), R"(, "question": )" + question);
        folder.write("asks.json", text);
        succeed({"lesson", "asks.json", "--animate", "-o", "asks.png", "--size", "320x180"});
        const std::string content = testing::fileContent(folder.path() / "asks.png");
        return testing::readApng({content.begin(), content.end()}).frames;
    };
    const auto choice = shots(R"({"text": "Which?", "kind": "choice", "choices": ["one", "two"], "right": 2})");
    const auto mark = shots(R"({"text": "Where?", "kind": "mark"})");
    ASSERT_EQ(choice.size(), 4u);
    ASSERT_EQ(mark.size(), 4u);
    for (const auto& frames : {choice, mark})
        for (std::size_t i = 1; i < 4; ++i)
            EXPECT_NE(frames[i - 1].shown, frames[i].shown) << i;
    // The answer differs from the question in words alone, or in the picture as well.
    EXPECT_GT(choice[1].part.y, 90);
    EXPECT_LT(mark[1].part.y, 90);
}

TEST_F(LessonCommandTest, WhatMovesIsPlayedToAndFro) {
    std::string text = lesson("5");
    text.insert(text.rfind('}'), R"(, "motion": {"frames": 3, "orbitLightDegrees": 60})");
    folder.write("moves.json", text);
    succeed({"lesson", "moves.json", "--animate", "-o", "moves.png", "--size", "320x180"});
    const std::string content = testing::fileContent(folder.path() / "moves.png");
    const auto frames = testing::readApng({content.begin(), content.end()}).frames;
    ASSERT_EQ(frames.size(), 2u * (1 + 3 * 4)); // of each state a picture to read, and three times 2nd, 3rd, 2nd, 1st
    EXPECT_EQ(frames[1].delayNumerator, 1u);
    EXPECT_NE(frames[0].shown, frames[1].shown);
    EXPECT_NE(frames[1].shown, frames[2].shown);
    EXPECT_EQ(frames[1].shown, frames[3].shown);
    EXPECT_EQ(frames[0].shown, frames[4].shown);
    EXPECT_EQ(frames[0].shown, frames[12].shown);
    EXPECT_NE(frames[0].shown, frames[13].shown);
}

TEST_F(LessonCommandTest, AFilmHoldsAPictureByRepeatingIt) {
    // In place of ffmpeg stands a script that keeps what it is given.
    const std::filesystem::path program = folder.write("bin/ffmpeg", "#!/bin/sh\ntee given.rgb >&3\n");
    ::chmod(program.c_str(), 0755);
    succeed({"lesson", "own.json", "--animate", "-o", "own.mp4", "--size", "320x180", "--hold", "0.5"},
            {.environment = {{"PATH", program.parent_path().string() + ":/usr/bin:/bin"}}});
    const std::string given = testing::fileContent(folder.path() / "given.rgb");
    const std::size_t picture = 320 * 180 * 3;
    ASSERT_EQ(given.size(), 2 * 5 * picture);
    EXPECT_EQ(given.substr(0, picture), given.substr(4 * picture, picture));
    EXPECT_NE(given.substr(0, picture), given.substr(5 * picture, picture));
}

TEST_F(LessonCommandTest, WithoutADisplayTheDemoWritesTheLesson) {
    const ProgramResult result =
        succeed({"demo", "--lesson", "own.json"}, {.environment = {{"DISPLAY", ""}, {"WAYLAND_DISPLAY", ""}}});
    EXPECT_NE(result.out.find("own-lesson.png"), std::string::npos) << result.shown();
    EXPECT_EQ(testing::headerOf(testing::fileContent(folder.path() / "own-lesson.png")).width, 1600u);
}

} // namespace
} // namespace shadowlab
