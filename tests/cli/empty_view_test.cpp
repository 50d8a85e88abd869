// A picture without a surface: `capture` and `measure` say why, once, however many pictures and techniques there are.
// SPDX-License-Identifier: MIT
#include "tests/cli/command_fixture.h"

namespace shadowlab::testing {
namespace {

using Words = std::vector<std::string>;

class EmptyViewCommandTest : public CommandTest {};

TEST_F(EmptyViewCommandTest, IsNotedOnceWithTheReason) {
    const std::string away = R"("camera": {"position": [0, 2, 4], "target": [0, 4, 9]})";
    folder.write("away.json", sceneText(away, kTwoLights, kBoxOnFloor));
    const auto notes = [&](const Words& more) {
        Words words{"capture", "away.json", "-o", "x_#.png", "--size", "64x48", "--labels", "false"};
        words.insert(words.end(), more.begin(), more.end());
        return succeed(words).err;
    };
    const std::string one = notes({"-t", "unshadowed,shadow-map"}),
                      many = notes({"--frames", "3", "--orbit-light", "9"});
    for (const std::string& said : {one, many})
        EXPECT_EQ(std::ranges::count(said, '\n'), 1) << said;
    EXPECT_TRUE(scene::contains(one, "note: no surface is in view: ")) << one;
    EXPECT_TRUE(scene::contains(many, "note: in frame 1 no surface is in view: ")) << many;
    EXPECT_TRUE(scene::contains(one, "\"target\": [0, ")) << one;
    EXPECT_FALSE(scene::contains(notes({"--stage", "outside"}), "no surface")) << "the second camera sees the scene";
    const std::string measured =
        succeed({"measure", "away.json", "--size", "64x48", "-t", "unshadowed,shadow-map"}).err;
    EXPECT_TRUE(scene::contains(measured, "nothing was measured: of 2 objects ")) << measured;
}

// A lamp that shines out of a room leaves it black, which is right, and a riddle.
TEST_F(EmptyViewCommandTest, ABlackPictureIsNoted) {
    const auto said = [&](const std::string& direction, const Words& more) {
        folder.write("spot.json", std::string("{") + kCamera + R"(, "ambient": [0, 0, 0], "background": [0, 0, 0],
            "lights": [{"type": "spot", "position": [0, 5, 0], "direction": [0, )" + direction + R"(, 0.01], "coneDegrees": 60, "intensity": 40}],
            )" + kBoxOnFloor + "}\n");
        Words words{"capture", "spot.json", "-o", "x.png", "--size", "64x48"};
        words.insert(words.end(), more.begin(), more.end());
        return succeed(words).err;
    };
    for (const std::string technique : {"unshadowed", "ray-traced", "radiosity"}) {
        EXPECT_TRUE(scene::contains(said("1", {"-t", technique}), "note: every pixel is black: no light reaches what is in view"));
        EXPECT_FALSE(scene::contains(said("-1", {"-t", technique}), "black"));
    }
    EXPECT_TRUE(scene::contains(said("1", {"-t", "unshadowed,shadow-map"}), "every pixel is black")) << "both are";
    EXPECT_FALSE(scene::contains(said("1", {"-t", "shadow-map", "--stage", "visibility@light1"}), "black")) << "a stage may be black";
    EXPECT_FALSE(scene::contains(said("-1", {"-t", "unshadowed,shadow-map", "--layout", "diff"}), "black")) << "and a difference of nothing";
    EXPECT_FALSE(scene::contains(said("1", {"-t", "shadow-map", "--steps", "--labels", "false"}), "black")) << "and a step";
}

} // namespace
} // namespace shadowlab::testing
