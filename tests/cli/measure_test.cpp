// `measure` as a user meets it: every key of its JSON, numbers that follow from captured visibility images, tables, and
// refusals.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include <nlohmann/json.hpp>

#include "tests/cli/command_fixture.h"

namespace shadowlab::testing {
namespace {

using Json = nlohmann::json;

class MeasureTest : public CommandTest {
protected:
    Json measured(const std::vector<std::string>& more) const {
        std::vector<std::string> arguments{"measure", "box.json", "--size", "320x240", "--json"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        const ProgramResult result = succeed(arguments);
        EXPECT_EQ(result.err, "") << result.shown();
        return Json::parse(result.out);
    }
    image::DecodedPng visibility(const std::string& technique, const std::vector<std::string>& more = {}) const {
        std::vector<std::string> arguments{"capture",    "box.json", "--size",  "320x240", "--stage",
                                           "visibility", "-t",       technique, "-o",      "visibility.png"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        succeed(arguments);
        return decoded(fileContent(folder.path() / "visibility.png"));
    }
};

TEST_F(MeasureTest, JsonHasEveryKey) {
    const Json json = measured({"-t", "all"});
    EXPECT_EQ(json.at("scene"), "box");
    EXPECT_EQ(json.at("size"), Json({320, 240}));
    EXPECT_FALSE(json.at("renderer").get<std::string>().empty());
    ASSERT_GE(json.at("results").size(), 4u);
    for (const Json& result : json.at("results")) {
        for (const char* key : {"technique",      "light",      "truth",  "pixels",   "lit",         "shadowed",
                                "turnedAway",     "ties",       "served", "falseLit", "falseShadow", "coreErrors",
                                "edgeErrorPx",    "boundaryPx", "rmse",   "psnr",     "ssim",        "flip",
                                "excessFlipRate", "converged",  "ms",     "counters"})
            EXPECT_TRUE(result.contains(key)) << key;
        EXPECT_EQ(result.at("light"), "key");
        const auto number = [&](const char* key) { return result.at(key).get<int>(); };
        EXPECT_EQ(number("pixels"), number("lit") + number("shadowed") + number("turnedAway") + number("ties"));
        EXPECT_GT(number("lit"), 500);
        EXPECT_GT(number("shadowed"), 500);
        EXPECT_GT(number("turnedAway"), 100);
        EXPECT_EQ(result.at("served"), 1.0);
        EXPECT_EQ(result.at("converged"), true);
        EXPECT_GT(result.at("ms").at("frame"), 0);
        EXPECT_GE(result.at("ms").at("prepare"), 0);
        EXPECT_FALSE(result.at("ms").at("passes").empty());
        EXPECT_TRUE(result.at("excessFlipRate").is_null()) << "a single frame cannot flicker";
    }
    const auto found = std::ranges::find_if(json.at("results"),
                                            [](const Json& result) { return result.at("technique") == "ray-traced"; });
    ASSERT_NE(found, json.at("results").end());
    const Json& traced = *found;
    EXPECT_TRUE(traced.at("psnr").is_null()) << "equal to itself";
    EXPECT_EQ(traced.at("ssim"), 1.0);
    EXPECT_EQ(traced.at("flip"), 0.0);
    EXPECT_EQ(traced.at("falseLit").get<int>() + traced.at("falseShadow").get<int>(), 0);
    EXPECT_EQ(traced.at("boundaryPx").at("max"), 0.0);
}

// Anybody can count: the visibility image of the technique against that of ray-traced.
TEST_F(MeasureTest, NumbersFollowFromVisibilityImages) {
    const std::vector<std::string> coarse{"--set", "shadow-map.resolution=64"};
    const Json result = measured({"-t", "shadow-map", coarse[0], coarse[1]}).at("results").at(0);
    const image::DecodedPng truth = visibility("ray-traced"), drawn = visibility("shadow-map", coarse);
    ASSERT_EQ(truth.image.rgba.size(), drawn.image.rgba.size());
    int covered = 0, lit = 0, falseLit = 0, falseShadow = 0;
    double squares = 0;
    for (std::size_t i = 0; i < truth.image.rgba.size(); i += 4) {
        if (truth.image.rgba[i + 3] != 255) continue;
        const int exact = truth.image.rgba[i], found = drawn.image.rgba[i];
        ++covered;
        lit += exact > 127;
        falseLit += exact <= 127 && found > 127;
        falseShadow += exact > 127 && found <= 127;
        squares += (found - exact) * (found - exact) / 255.0 / 255.0;
    }
    const int ties = result.at("ties");
    ASSERT_LT(ties, covered / 500);
    EXPECT_EQ(result.at("pixels"), covered);
    EXPECT_NEAR(result.at("lit"), lit, ties);
    EXPECT_NEAR(result.at("falseLit"), falseLit, ties);
    EXPECT_NEAR(result.at("falseShadow"), falseShadow, ties);
    EXPECT_GT(falseLit + falseShadow, 20);
    EXPECT_NEAR(result.at("rmse"), std::sqrt(squares / covered),
                std::sqrt((squares + ties) / covered) - std::sqrt(squares / covered) + 1e-9);
}

TEST_F(MeasureTest, LightIsChosenByName) {
    const Json key = measured({"-t", "unshadowed"}), sun = measured({"-t", "unshadowed", "--light", "sun"});
    EXPECT_EQ(sun.at("results").at(0).at("light"), "sun");
    EXPECT_NE(key.at("results").at(0).at("shadowed"), sun.at("results").at(0).at("shadowed"));
}

TEST_F(MeasureTest, SaysWhichTruthWasUsed) {
    const std::string lights =
        R"("lights": [{"name": "panel", "type": "rect", "position": [1, 4, 1], "edgeU": [1, 0, 0], "edgeV": [0, 0, 1]}])";
    folder.write("panel.json", sceneText(kCamera, lights, kBoxOnFloor));
    const std::vector<std::string> arguments{"measure", "panel.json",
                                             "--size",  "160x120",
                                             "-t",      "shadow-map,unshadowed",
                                             "--set",   "shadow-map.light-samples=4"};
    std::vector<std::string> withJson = arguments;
    withJson.emplace_back("--json");
    const Json results = Json::parse(succeed(withJson).out).at("results");
    EXPECT_EQ(results.at(0).at("truth"), "area");
    EXPECT_EQ(results.at(1).at("truth"), "centre");
    const std::string table = succeed(arguments).out;
    for (const char* word : {"centre, pixels", "area, pixels"})
        EXPECT_NE(table.find(word), std::string::npos) << word << "\n" << table;
}

// With one point the share of a pixel is the truth at its centre, so its errors are those that are measured anyway: over the pixels
// that face the light, where turned away ones have none.
TEST_F(MeasureTest, ShareOfOnePointIsTheTruthAtTheCentre) {
    const Json result =
        measured({"-t", "shadow-map", "--set", "shadow-map.resolution=64", "--subpixel", "1"}).at("results").at(0);
    const Json& all = result.at("coverage").at("all");
    const double facing = result.at("lit").get<double>() + result.at("shadowed").get<double>();
    EXPECT_EQ(all.at("pixels"), facing);
    const double judged = facing + result.at("turnedAway").get<double>();
    const double squares = all.at("rmse").get<double>() * all.at("rmse").get<double>() * facing;
    EXPECT_GT(squares, 20);
    EXPECT_NEAR(result.at("rmse"), std::sqrt(squares / judged), 1e-6); // shares are floats
    EXPECT_EQ(result.at("coverage").at("edge").at("pixels"), 0) << "one point crosses nothing";
}

TEST_F(MeasureTest, ShareOfPixelsIsNearerWithMoreSamples) {
    const std::vector<std::string> asked{"-t", "shadow-volume-zfail", "--subpixel", "64", "--supersample"};
    std::vector<double> errors;
    for (const char* samples : {"1", "2", "4"}) {
        std::vector<std::string> arguments = asked;
        arguments.emplace_back(samples);
        const Json json = measured(arguments);
        const Json& coverage = json.at("results").at(0).at("coverage");
        EXPECT_GT(json.at("coverageMs"), 0);
        EXPECT_EQ(coverage.at("points"), 64);
        EXPECT_EQ(coverage.at("samples"), std::stoi(samples));
        for (const char* part : {"all", "edge", "outline"})
            EXPECT_GT(coverage.at(part).at("pixels"), 100) << part;
        errors.push_back(coverage.at("edge").at("rmse"));
        EXPECT_LE(coverage.at("edge").at("mean"), errors.back());
        EXPECT_LE(errors.back(), coverage.at("edge").at("max"));
    }
    // The share of a pixel beside an edge is anything, and the nearest of n * n + 1 shades is on average 1/n times as far.
    EXPECT_NEAR(errors[0], std::sqrt(1.0 / 12), 0.05);
    EXPECT_LT(errors[1], 0.6 * errors[0]);
    EXPECT_LT(errors[2], 0.6 * errors[1]);
}

TEST_F(MeasureTest, SharesAreSaidOnlyWhereAsked) {
    EXPECT_FALSE(measured({"-t", "unshadowed"}).contains("coverageMs"));
    EXPECT_FALSE(measured({"-t", "unshadowed"}).at("results").at(0).contains("coverage"));
    const std::vector<std::string> arguments{"measure", "box.json", "--size", "160x120"};
    EXPECT_EQ(succeed(arguments).out.find("share of a pixel"), std::string::npos);
    std::vector<std::string> asked = arguments;
    asked.insert(asked.end(), {"--subpixel", "32", "--supersample", "2"});
    const std::string table = succeed(asked).out;
    for (const char* word : {"share of a pixel", "2 x 2 samples against 32 points", "edge pixels", "outline pixels"})
        EXPECT_NE(table.find(word), std::string::npos) << word << "\n" << table;
}

TEST_F(MeasureTest, SequencesHaveFlips) {
    const Json json = measured(
        {"-t", "ray-traced,shadow-map", "--set", "shadow-map.resolution=64", "--frames", "4", "--orbit-light", "2"});
    EXPECT_EQ(json.at("frames"), 4);
    EXPECT_EQ(json.at("results").at(0).at("excessFlipRate"), 0.0);
    EXPECT_GT(json.at("results").at(1).at("excessFlipRate"), 0.0);
}

TEST_F(MeasureTest, TwoSlotsOfOneTechniqueWithTheirOwnSettings) {
    const Json json = measured({"-t", "shadow-map,shadow-map", "--set", "1:shadow-map.resolution=64", "--set",
                                "2:shadow-map.resolution=1024"});
    EXPECT_GT(json.at("results").at(0).at("edgeErrorPx"), json.at("results").at(1).at("edgeErrorPx"));
}

TEST_F(MeasureTest, TableNamesWhatItShows) {
    const ProgramResult result = succeed({"measure", "box.json", "--size", "160x120", "-t", "all"});
    for (const char* word :
         {"box", "light 'key'", "160x120", "lit", "in shadow", "turned away", "ties", "false lit", "false shadow",
          "core", "RMSE", "PSNR", "SSIM", "FLIP", "shadow-volume-zfail", "equal", "frame", "prepare", "counters"})
        EXPECT_NE(result.out.find(word), std::string::npos) << word << "\n" << result.out;
}

TEST_F(MeasureTest, SaysWhenNothingIsProved) {
    folder.write("open.json", sceneText(kCamera, kTwoLights, R"("objects": [{"shape": "quad", "size": [12, 12]}])"));
    const ProgramResult result = succeed({"measure", "open.json", "--size", "64x48"});
    EXPECT_NE(result.err.find("proves nothing"), std::string::npos) << result.shown();
    folder.write("empty.json", sceneText(kCamera, kTwoLights, R"("objects": [])"));
    EXPECT_NE(succeed({"measure", "empty.json", "--size", "64x48", "--json"}).err.find("nothing was measured"),
              std::string::npos);
}

TEST_F(MeasureTest, Refusals) {
    folder.write("dark.json", sceneText(kCamera, R"("lights": [])", kBoxOnFloor));
    expectRefused({"measure", "dark.json"}, 3, {"dark", "no light"});
    expectRefused({"measure"}, 2, {"SCENE"});
    expectRefused({"measure", "box.json", "--light", "kex"}, 2, {"kex", "key"});
    expectRefused({"measure", "box.json", "-t", "shadow-mop"}, 2, {"shadow-mop", "shadow-map"});
    expectRefused({"measure", "box.json", "--size", "9000x10"}, 6, {"9000"});
    expectRefused({"measure", "box.json", "--orbit-light", "10"}, 2, {"--frames"});
    expectRefused({"measure", "box.json", "--supersample", "2"}, 2, {"--supersample", "--subpixel"});
    expectRefused({"measure", "box.json", "--subpixel", "0"}, 2, {"--subpixel", "256"});
    expectRefused({"measure", "box.json", "--subpixel", "257"}, 2, {"--subpixel", "256"});
    expectRefused({"measure", "box.json", "--subpixel", "8", "--supersample", "17"}, 6, {"--supersample", "16"});
    expectRefused({"measure", "box.json", "--output", "x"}, 2, {"--output"});
    expectRefused({"measure", "no-such-scene"}, 3, {"no-such-scene"});
}

} // namespace
} // namespace shadowlab::testing
