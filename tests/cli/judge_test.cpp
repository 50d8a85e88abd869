// `judge` as it is run: pictures of the program's own techniques stand for those of others.
// SPDX-License-Identifier: MIT
#include <nlohmann/json.hpp>

#include "app/foreign/calibration_board.h"
#include "techniques/foundation/scene/json/write_scene.h"
#include "tests/cli/command_fixture.h"

namespace shadowlab::testing {
namespace {

using Json = nlohmann::json;

class JudgeCommandTest : public CommandTest {
protected:
    /// The visibility image of the key light, 160 x 90 pixels.
    void draw(const std::string& file, const std::string& technique, const std::vector<std::string>& more = {}) const {
        std::vector<std::string> words{"capture", "box.json", "-o", file, "-t", technique, "--size", "160x90", "--stage", "visibility", "--light", "key"};
        words.insert(words.end(), more.begin(), more.end());
        succeed(words);
    }
    [[nodiscard]] Json judged(const std::vector<std::string>& words, int status) const {
        std::vector<std::string> all{"judge"};
        all.insert(all.end(), words.begin(), words.end());
        all.emplace_back("--json");
        const ProgramResult result = run(all);
        EXPECT_EQ(result.status, status) << result.shown();
        const Json json = Json::parse(result.out, nullptr, false);
        EXPECT_FALSE(json.is_discarded()) << result.shown();
        return json;
    }
};

TEST_F(JudgeCommandTest, ARightPictureEndsWithZero) {
    draw("ok.png", "shadow-volume-zfail");
    const Json json = judged({"ok.png", "box.json", "--light", "key"}, 0);
    EXPECT_EQ(json["judged"]["falseLit"], 0);
    EXPECT_EQ(json["judged"]["falseShadow"], 0);
    EXPECT_GT(json["judged"]["shadowed"], 150);
    EXPECT_GT(json["judged"]["lit"], 5000);
    EXPECT_TRUE(json["causes"].empty());
    EXPECT_TRUE(json["region"].is_null());
}

TEST_F(JudgeCommandTest, CountsWhatMeasureCounts) {
    draw("acne.png", "shadow-map", {"--set", "shadow-map.bias-mode=none", "--set", "shadow-map.filter=hard"});
    const Json json = judged({"acne.png", "box.json", "--light", "key"}, 1);
    const Json measured = Json::parse(succeed({"measure", "box.json", "-t", "shadow-map", "--light", "key", "--size", "160x90", "--set",
                                               "shadow-map.bias-mode=none", "--set", "shadow-map.filter=hard", "--json"}).out)["results"][0];
    // The rasteriser that measure asks may add ties; there are none of those in this view. Core errors know no texels here.
    int compared = 0;
    for (const char* key : {"pixels", "lit", "shadowed", "turnedAway", "ties", "falseLit", "falseShadow", "stray", "edgeErrorPx", "boundaryPx", "rmse"}) {
        EXPECT_EQ(json["judged"][key], measured[key]) << key;
        ++compared;
    }
    EXPECT_EQ(compared, 11);
    EXPECT_GT(json["judged"]["falseLit"].get<int>() + json["judged"]["falseShadow"].get<int>(), 20);
    ASSERT_FALSE(json["causes"].empty());
    EXPECT_EQ(json["causes"][0]["cause"], "acne") << json.dump(2);
    EXPECT_FALSE(json["region"].is_null());
}

TEST_F(JudgeCommandTest, AShadedPictureIsJudgedBesideOneWithoutShadows) {
    // One light: the other would cast shadows of its own.
    folder.write("one.json", sceneText(kCamera, R"("lights": [{"name": "key", "type": "point", "position": [2, 5, 3], "intensity": 40}])", kBoxOnFloor));
    for (const auto& [file, technique] : {std::pair("shaded.png", "shadow-volume-zfail"), std::pair("bare.png", "unshadowed")})
        succeed({"capture", "one.json", "-o", file, "-t", technique, "--size", "160x90", "--labels", "false"});
    const Json json = judged({"shaded.png", "one.json", "--reference", "bare.png"}, 0);
    EXPECT_EQ(json["kind"], "shaded");
    EXPECT_GT(json["judged"]["shadowed"], 150);
    EXPECT_LT(json["judged"]["notJudged"], 100);
    // Without its reference it is no visibility image.
    expectRefused({"judge", "shaded.png", "one.json"}, 3, {"shaded.png", "--reference"});
    // Beside itself it has no shadows at all.
    const Json none = judged({"bare.png", "one.json", "--reference", "bare.png"}, 1);
    EXPECT_EQ(none["causes"][0]["cause"], "no-shadows");
}

TEST_F(JudgeCommandTest, WritesThePictureOfErrorsAndTheSection) {
    draw("acne.png", "shadow-map", {"--set", "shadow-map.bias-mode=none", "--set", "shadow-map.filter=hard"});
    const ProgramResult result = run({"judge", "acne.png", "box.json", "--light", "key", "-o", "found"});
    EXPECT_EQ(result.status, 1) << result.shown();
    EXPECT_NE(result.out.find("looks like: "), std::string::npos) << result.out;
    EXPECT_NE(result.out.find("remedy: "), std::string::npos) << result.out;
    const PngHeader errors = headerOf(fileContent(folder.path() / "found/errors.png")), visibility = headerOf(fileContent(folder.path() / "found/visibility.png"));
    EXPECT_EQ(errors.width, 160u);
    EXPECT_EQ(visibility.colorType, 4);
    const std::string section = fileContent(folder.path() / "found/section.svg");
    EXPECT_NE(section.find("<svg"), std::string::npos);
    EXPECT_NE(section.find(" is dark in the picture; the section shows"), std::string::npos) << "the figure says whose it is";
    const ProgramResult json = run({"judge", "acne.png", "box.json", "--light", "key", "-o", "found", "--json"});
    EXPECT_NE(json.out.find("\"section\": \"pixel "), std::string::npos) << json.out;
}

TEST_F(JudgeCommandTest, AWrongCalibrationIsSaidAndNothingIsJudged) {
    draw("ok.png", "shadow-volume-zfail");
    scene::LoadOptions options;
    const scene::Snapshot box = scene::loadScene((folder.path() / "box.json").string(), options);
    scene::Scene board = foreign::calibrationBoard(box->camera, {160, 90});
    board.background = vec3(0.4f); // of a program; the board brings a black one of its own
    folder.write("board.json", scene::sceneText(board, board.camera, folder.path()));
    succeed({"capture", "board.json", "-o", "board.png", "-t", "unshadowed", "--size", "160x90", "--labels", "false"});
    succeed({"capture", "board.json", "-o", "wide.png", "-t", "unshadowed", "--size", "160x91", "--labels", "false"});
    const Json right = judged({"ok.png", "box.json", "--light", "key", "--calibration", "board.png"}, 0);
    EXPECT_EQ(right["calibration"]["right"], true);
    const Json wrong = judged({"ok.png", "box.json", "--light", "key", "--calibration", "wide.png"}, 3);
    EXPECT_EQ(wrong["calibration"]["faults"][0]["fault"], "size");
    EXPECT_TRUE(wrong["judged"].is_null());
    const Json stranger = judged({"ok.png", "box.json", "--light", "key", "--calibration", "ok.png"}, 3);
    EXPECT_EQ(stranger["calibration"]["faults"][0]["fault"], "not-the-board");
}

TEST_F(JudgeCommandTest, RefusesWhatItCannotJudge) {
    draw("ok.png", "shadow-volume-zfail");
    succeed({"capture", "box.json", "-o", "other.png", "-t", "unshadowed", "--size", "80x45", "--labels", "false"});
    folder.write("no.png", "this is no picture");
    folder.write("dark.json", "{" + std::string(kCamera) + ", " + kBoxOnFloor + "}");
    expectRefused({"judge", "none.png", "box.json"}, 3, {"none.png"});
    expectRefused({"judge", "no.png", "box.json"}, 3, {"no.png", "PNG"});
    expectRefused({"judge", "ok.png", "none.json"}, 3, {"none.json"});
    expectRefused({"judge", "ok.png", "dark.json"}, 3, {"dark.json", "no light"});
    expectRefused({"judge", "ok.png", "box.json", "--light", "moon"}, 2, {"moon", "key"});
    expectRefused({"judge", "ok.png", "box.json", "--size", "320x180"}, 3, {"ok.png", "160 x 90", "320 x 180"});
    expectRefused({"judge", "ok.png", "box.json", "--reference", "other.png"}, 3, {"other.png", "80 x 45"});
    expectRefused({"judge", "ok.png"}, 2, {"SCENE"});
    expectRefused({"judge", "ok.png", "box.json", "--light", "key", "-o", "ok.png"}, 4, {"ok.png"});
}

// A program without areas draws a lamp's hard shadow, whose edge lies where half of the area is seen only here and there.
TEST_F(JudgeCommandTest, AWideLightIsJudgedByItsCentreWhereThatIsAsked) {
    const std::vector<std::string> drawing{"capture", "room-with-lamps", "-o", "hard.png", "-t", "ray-traced", "--set", "ray-traced.soft-shadows=off",
                                           "--stage", "visibility", "--light", "panel", "--size", "160x90"};
    succeed(drawing);
    const Json asArea = judged({"hard.png", "room-with-lamps", "--light", "panel"}, 1);
    const Json asPoint = judged({"hard.png", "room-with-lamps", "--light", "panel", "--by-centre"}, 0);
    EXPECT_EQ(asPoint["judged"]["falseLit"].get<int>() + asPoint["judged"]["falseShadow"].get<int>(), 0);
    EXPECT_GT(asPoint["judged"]["shadowed"], 100);
    EXPECT_GT(asPoint["judged"]["lit"], 3000);
    EXPECT_GT(asArea["judged"]["falseLit"].get<int>() + asArea["judged"]["falseShadow"].get<int>(), 20);
}

} // namespace
} // namespace shadowlab::testing
