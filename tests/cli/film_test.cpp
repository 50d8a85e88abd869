// `capture --steps` and `--animate`: one file of many pictures, each the same as a capture of it alone.
// SPDX-License-Identifier: MIT
#include <numeric>

#include <sys/stat.h>

#include "tests/cli/command_fixture.h"
#include "tests/support/apng_reader.h"

namespace shadowlab::testing {
namespace {

class FilmTest : public CommandTest {
protected:
    [[nodiscard]] Apng filmOf(const std::string& file) const {
        const std::string content = fileContent(folder.path() / file);
        return readApng({content.begin(), content.end()});
    }
    [[nodiscard]] image::Image pictureOf(const std::string& file) const { return image::loadPng(folder.path() / file); }
    /// The upper part of a picture.
    static image::Image top(const image::Image& picture, int height) {
        image::Image part(picture.width, height);
        image::blit(part, 0, 0, picture);
        return part;
    }
    /// A program that is called ffmpeg and does what is said, first in the PATH.
    [[nodiscard]] ProgramSetting withFfmpeg(const std::string& script) const {
        const std::filesystem::path program = folder.write("bin/ffmpeg", "#!/bin/sh\n" + script);
        ::chmod(program.c_str(), 0755);
        return {.environment = {{"PATH", program.parent_path().string() + ":/usr/bin:/bin"}}};
    }
    static std::vector<std::string> joined(std::vector<std::string> words, const std::vector<std::string>& more) {
        words.insert(words.end(), more.begin(), more.end());
        return words;
    }
    const std::vector<std::string> turn{"capture", "box.json", "-t", "shadow-map",    "--size",
                                        "160x90",  "--frames", "4",  "--orbit-light", "120"};
    const std::vector<std::string> steps{"capture", "box.json", "-t", "shadow-map", "--size", "320x180", "--steps"};
};

TEST_F(FilmTest, FramesOfAnAnimationAreTheFramesWrittenOneByOne) {
    succeed(joined(turn, {"--animate", "--fps", "12", "-o", "turn.png"}));
    succeed(joined(turn, {"-o", "turn_##.png"}));
    const Apng film = filmOf("turn.png");
    ASSERT_EQ(film.frames.size(), 4u);
    bool isCropped = false;
    for (std::size_t i = 0; i < 4; ++i) {
        EXPECT_EQ(film.frames[i].shown, pictureOf("turn_0" + std::to_string(i + 1) + ".png")) << i;
        EXPECT_EQ(film.frames[i].delayNumerator, 1u);
        EXPECT_EQ(film.frames[i].delayDenominator, 12u);
        isCropped = isCropped || film.frames[i].part.height < 90;
    }
    EXPECT_TRUE(isCropped) << "the sky stays as it is";
    // Who knows nothing of animations sees the first frame, and its settings.
    EXPECT_EQ(decoded(fileContent(folder.path() / "turn.png")).image, pictureOf("turn_01.png"));
    EXPECT_FALSE(decoded(fileContent(folder.path() / "turn.png")).text.empty());
}

TEST_F(FilmTest, TheSameCommandWritesTheSameBytes) {
    for (const char* name : {"once.png", "again.png"})
        succeed(joined(turn, {"--animate", "-o", name}));
    const std::string once = fileContent(folder.path() / "once.png");
    EXPECT_GT(once.size(), 1000u);
    EXPECT_EQ(once, fileContent(folder.path() / "again.png"));
}

TEST_F(FilmTest, StepsAreWhatTheyAreAloneAndEachHasItsTitleBelow) {
    succeed(joined(steps, {"--hold", "1.5", "-o", "steps.png"}));
    const Apng film = filmOf("steps.png");
    // lights-off, and of two lights each the map and the comparison. A step that writes a map shows the map.
    const std::vector<std::string> stages{"pass:lights-off", "light-depth@key", "pass:light@key", "light-depth@sun",
                                          "pass:light@sun"};
    ASSERT_EQ(film.frames.size(), stages.size());
    int height = 0; // of the pictures: the rest of each frame is its title
    for (height = film.height; height > 0; --height) {
        const image::Color8 left = film.frames[0].shown.at(0, height - 1);
        if (left != film.frames[0].shown.at(0, film.height - 1)) break;
    }
    EXPECT_GT(height, 120);
    EXPECT_LT(height, 165);
    std::vector<image::Image> titles;
    for (std::size_t i = 0; i < stages.size(); ++i) {
        succeed({"capture", "box.json", "-t", "shadow-map", "--size", "320x" + std::to_string(height), "--stage",
                 stages[i], "-o", "alone.png"});
        const image::Image step = top(film.frames[i].shown, height), alone = pictureOf("alone.png");
        if (i == 0) // nearly black: as a step it is shown brighter, and says so
            EXPECT_GT(std::accumulate(step.rgba.begin(), step.rgba.end(), 0L), std::accumulate(alone.rgba.begin(), alone.rgba.end(), 0L));
        else
            EXPECT_EQ(step, alone) << stages[i];
        EXPECT_EQ(film.frames[i].delayNumerator, 1500u);
        EXPECT_EQ(film.frames[i].delayDenominator, 1000u);
        image::Image title(film.width, film.height - height);
        image::blit(title, 0, -height, film.frames[i].shown);
        EXPECT_EQ(std::ranges::find(titles, title), titles.end()) << "each title is another one: " << i;
        titles.push_back(title);
    }
}

TEST_F(FilmTest, WithoutTitlesThePictureIsAsLargeAsTheFile) {
    succeed(joined(steps, {"--labels", "false", "-o", "steps.png"}));
    const Apng film = filmOf("steps.png");
    succeed({"capture", "box.json", "-t", "shadow-map", "--size", "320x180", "-o", "finished.png"});
    ASSERT_EQ(film.frames.size(), 5u);
    EXPECT_EQ(film.frames.back().shown, pictureOf("finished.png")) << "after the last step the picture is finished";
}

TEST_F(FilmTest, StepsOfTheWindowShowTheirSource) {
    succeed({"capture", "box.json", "-t", "shadow-map", "--size", "640x480", "--steps", "--ui", "--source", "true",
             "-o", "window.png"});
    const Apng film = filmOf("window.png");
    ASSERT_EQ(film.frames.size(), 5u);
    succeed({"capture", "box.json", "-t", "shadow-map", "--size", "640x480", "--ui", "--source", "true", "--stage",
             "pass:light@sun", "-o", "alone.png"});
    EXPECT_EQ(film.frames.back().shown, pictureOf("alone.png"));
}

TEST_F(FilmTest, AFilmIsMadeOfAllPixelsOfAllFrames) {
    // In place of ffmpeg stands a script that keeps what it is given: the words, and the pictures.
    const ProgramSetting setting = withFfmpeg("echo \"$@\" > words.txt\ncat > given.rgb\ncat given.rgb >&3\n");
    succeed(joined(turn, {"--animate", "--fps", "10", "-o", "turn.mp4"}), setting);
    succeed(joined(turn, {"-o", "turn_##.png"}));
    const std::string film = fileContent(folder.path() / "turn.mp4"), words = fileContent(folder.path() / "words.txt");
    ASSERT_EQ(film.size(), 4u * 160 * 90 * 3);
    std::size_t at = 0, compared = 0;
    for (int frame = 1; frame <= 4; ++frame) {
        const image::Image picture = pictureOf("turn_0" + std::to_string(frame) + ".png");
        for (std::size_t i = 0; i < picture.rgba.size(); i += image::kChannels)
            for (std::size_t channel = 0; channel < 3; ++channel, ++at)
                compared += static_cast<std::uint8_t>(film[at]) == picture.rgba[i + channel] ? 1 : 0;
    }
    EXPECT_EQ(compared, film.size());
    for (const char* said : {"-video_size 160x90", "-framerate 10/1", "rgb24", "+faststart"})
        EXPECT_NE(words.find(said), std::string::npos) << said << " in " << words;
}

TEST_F(FilmTest, AFilmThatCannotBeMadeLeavesNothingBehind) {
    const std::vector<std::string> film = joined(turn, {"--animate", "-o", "turn.mp4"});
    expectRefused(film, 4, {"turn.mp4", "the package ffmpeg", "turn.png"}, {.environment = {{"PATH", "/nowhere"}}});
    // It fails half way, having written something; it takes nothing; it ends well and has written nothing.
    expectRefused(film, 4, {"no room in the studio"},
                  withFfmpeg("head -c 50000 > /dev/null; echo begun >&3; echo no room in the studio >&2; exit 1\n"));
    expectRefused(film, 4, {"refused"}, withFfmpeg("echo refused >&2; exit 3\n"));
    expectRefused(film, 4, {"without saying why"}, withFfmpeg("cat > /dev/null\n"));
    // What was there before stays.
    folder.write("turn.mp4", "an older film");
    expectRefused(film, 4, {"refused"}, withFfmpeg("echo refused >&2; exit 3\n"));
}

TEST_F(FilmTest, WhatCannotBeInOneFileIsRefused) {
    const auto refuse = [&](const std::vector<std::string>& more, const std::vector<std::string>& parts) {
        std::vector<std::string> words{"capture", "box.json", "-o", "film.png"};
        expectRefused(joined(std::move(words), more), 2, parts);
    };
    refuse({"--animate"}, {"--animate", "--frames"});
    refuse({"--fps", "10"}, {"--fps", "--animate"});
    refuse({"--hold", "1"}, {"--hold", "--steps"});
    refuse({"--steps", "--hold", "0"}, {"--hold", "0.01 to 60"});
    refuse({"--steps", "--hold", "long"}, {"'long'"});
    refuse({"--steps", "--animate", "--frames", "3"}, {"--steps", "--animate"});
    refuse({"--steps", "--frames", "3"}, {"--steps", "--frames"});
    refuse({"--steps", "-t", "shadow-map,planar"}, {"--steps", "2 techniques"});
    refuse({"--steps", "--stage", "visibility"}, {"--steps", "--stage"});
    refuse({"--steps", "--stats", "s.json"}, {"--stats", "--steps"});
    refuse({"--steps", "--size", "300x30"}, {"--size", "titles"});
    refuse({"--animate", "--frames", "2", "--stage", "visibility"}, {"--animate", "visibility"});
    refuse({"--source", "true"}, {"--source", "--ui"});
    expectRefused({"capture", "box.json", "-o", "film.mp4"}, 2, {"film.mp4", "--steps"});
    expectRefused({"capture", "box.json", "--steps", "-o", "film.gif"}, 2, {"film.gif", ".png"});
}

} // namespace
} // namespace shadowlab::testing
