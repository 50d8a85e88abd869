// `capture` as a user runs it: what is promised exists, in the promised form, and twice the same.
// SPDX-License-Identifier: MIT
#include <nlohmann/json.hpp>

#include "tests/cli/command_fixture.h"

namespace shadowlab::testing {
namespace {

using Words = std::vector<std::string>;

class CaptureTest : public CommandTest {
protected:
    /// Captures the box with further options, expects one new file and returns it.
    std::string picture(const Words& options, const ProgramSetting& setting = {}) const {
        Words arguments = {"capture", "box.json", "-o", "x.png", "--size", "64x48"};
        arguments.insert(arguments.end(), options.begin(), options.end());
        std::filesystem::remove(folder.path() / "x.png");
        const Listing before = listing();
        const ProgramResult result = succeed(arguments, setting);
        EXPECT_EQ(result.out, "");
        if (!result.err.empty()) { // labels are left out of pictures this small
            EXPECT_TRUE(result.err.starts_with("shadowlab: note: ")) << result.err;
        }
        EXPECT_EQ(newSince(before), Words{"x.png"});
        return content("x.png");
    }
    std::string content(const std::string& name) const { return fileContent(folder.path() / name); }
    image::Image pixels(const Words& options) const { return decoded(picture(options)).image; }
};

TEST_F(CaptureTest, PictureIsOpaqueRgbOfTheSize) {
    const PngHeader header = headerOf(picture({}));
    EXPECT_EQ(header.width, 64u);
    EXPECT_EQ(header.height, 48u);
    EXPECT_EQ(header.bitDepth, 8);
    EXPECT_EQ(header.colorType, 2);
}

TEST_F(CaptureTest, TwiceTheSameBytes) {
    for (const Words& options : {Words{}, Words{"-t", "shadow-map,shadow-volume-zfail"}, Words{"--stage", "visibility"},
                                 Words{"-t", "shadow-map", "--stage", "light-depth", "--supersample", "2"},
                                 Words{"-t", "shadow-map,ray-traced", "--stage", "outside@sun"}})
        EXPECT_EQ(picture(options), picture(options));
}

TEST_F(CaptureTest, VolumesSeenFromOutsideAreThoseAskedFor) {
    const auto with = [&](const Words& more) {
        Words words{"-t", "shadow-volume-zfail", "--stage", "outside"};
        words.insert(words.end(), more.begin(), more.end());
        return picture(words);
    };
    EXPECT_NE(with({"--near-clip"}), with({}));
    expectRefused({"capture", "box.json", "-o", "y.png", "-t", "shadow-volume-zfail", "--stage", "outside", "--volumes", "nobody"},
                  2, {"--volumes", "nobody", "all"});
    expectRefused({"capture", "box.json", "-o", "y.png", "--volumes", "all"}, 2, {"--volumes", "--stage outside"});
}

TEST_F(CaptureTest, APixelsRaysSeenFromOutside) {
    const Words outside{"-t", "ray-traced", "--stage", "outside"};
    const auto with = [&](const char* pixel) {
        Words words = outside;
        words.insert(words.end(), {"--pixel", pixel});
        return words;
    };
    const std::string one = picture(with("32,30"));
    EXPECT_NE(one, picture(outside));
    EXPECT_NE(one, picture(with("20,30")));
    EXPECT_EQ(one, picture(with("32,30")));
    expectRefused({"capture", "box.json", "-o", "y.png", "--size", "64x48", "-t", "planar,ray-traced", "--stage",
                   "outside", "--pixel", "40,10"},
                  2, {"--pixel", "32 x 48"});
}

TEST_F(CaptureTest, FormFactorsAreThoseOfThePixelsPatch) {
    const auto with = [&](Words more) {
        Words words{"-t", "radiosity", "--set", "radiosity.patches=20", "--stage", "form-factors"};
        words.insert(words.end(), more.begin(), more.end());
        return pixels(words).rgba; // its texts name the options
    };
    // Lower left and right of the floor, around the box.
    const auto brightest = with({}), left = with({"--pixel", "4,40"}), right = with({"--pixel", "60,40"});
    EXPECT_NE(left, right);
    EXPECT_TRUE(left != brightest || right != brightest);
    EXPECT_EQ(left, with({"--pixel", "4,40"}));
    EXPECT_EQ(left, with({"--pixel", "4,40", "--set", "radiosity.from-patch=3"}))
        << "the pixel comes before the parameter";
}

TEST_F(CaptureTest, ASecondPixelIsSeenFromOutsideInRadiosityAlone) {
    const auto with = [&](const char* technique, bool hasPartner) {
        Words words{"-t", technique, "--stage", "outside", "--pixel", "32,30"};
        if (hasPartner) words.insert(words.end(), {"--partner", "4,40"});
        if (std::string_view(technique) == "radiosity") words.insert(words.end(), {"--set", "radiosity.patches=20"});
        return pixels(words).rgba; // its texts name the options
    };
    EXPECT_NE(with("radiosity", true), with("radiosity", false));
    EXPECT_EQ(with("ray-traced", true), with("ray-traced", false));
}

TEST_F(CaptureTest, ACommaLocaleChangesNothing) {
    const std::string expected = picture({"-t", "shadow-map", "--set", "shadow-map.slope-bias=1.5"});
    // A locale of our own making where the system has none; without the tool the variable alone is tried.
    shell("localedef -f UTF-8 -i de_DE ./de_DE.UTF-8");
    const std::map<std::string, std::string> german = {
        {"LC_ALL", "de_DE.UTF-8"}, {"LANG", "de_DE.UTF-8"}, {"LOCPATH", folder.path().string()}};
    EXPECT_EQ(picture({"-t", "shadow-map", "--set", "shadow-map.slope-bias=1.5"}, {.environment = german}), expected);
}

TEST_F(CaptureTest, OnePixelAndOddSizes) {
    for (const std::string size : {"1x1", "1x7", "333x1", "63x47"}) {
        succeed({"capture", "box.json", "-o", "x.png", "--size", size});
        const PngHeader header = headerOf(content("x.png"));
        EXPECT_EQ(std::to_string(header.width) + "x" + std::to_string(header.height), size);
    }
}

TEST_F(CaptureTest, VisibilityIsGreyAndAlphaAndNeverSupersampled) {
    const std::string plain = picture({"--stage", "visibility"});
    const PngHeader header = headerOf(plain);
    EXPECT_EQ(header.width, 64u);
    EXPECT_EQ(header.height, 48u);
    EXPECT_EQ(header.bitDepth, 8);
    EXPECT_EQ(header.colorType, 4);
    EXPECT_EQ(picture({"--stage", "visibility", "--supersample", "4"}), plain);

    const image::Image pixels = decoded(plain).image;
    int lit = 0, dark = 0, sky = 0;
    for (int y = 0; y < pixels.height; ++y)
        for (int x = 0; x < pixels.width; ++x) {
            const image::Color8 pixel = pixels.at(x, y);
            EXPECT_TRUE(pixel.a == 255 || (pixel.a == 0 && pixel.r == 0));
            ++(pixel.a == 0 ? sky : pixel.r == 255 ? lit : dark);
        }
    EXPECT_GT(lit, 100);
    EXPECT_GT(dark, 20);
    EXPECT_GT(sky, 100);
}

TEST_F(CaptureTest, VisibilityOfALight) {
    const auto image = [&](const Words& options) { return pixels(options).rgba; };
    const auto key = image({"--stage", "visibility"}), sun = image({"--stage", "visibility@sun"});
    EXPECT_NE(key, sun);
    EXPECT_EQ(key, image({"--stage", "visibility@key"}));
    EXPECT_EQ(key, image({"--stage", "visibility", "--light", "key"}));
    EXPECT_EQ(sun, image({"--stage", "visibility", "--light", "sun"}));
    EXPECT_EQ(sun, image({"--stage", "visibility@sun", "--light", "key"}));
}

// Four to a picture, which takes a quarter of the processes.
TEST_F(CaptureTest, EveryStageOfEveryTechnique) {
    const auto draw = [&](const std::string& technique, const std::vector<std::string>& stages) {
        Words words = {"capture", "box.json", "-o", "x.png", "--size", "320x240", "--layout", "grid"};
        std::string slots;
        for (std::size_t i = 0; i < stages.size(); ++i) {
            slots += (i > 0 ? "," : "") + technique;
            words.insert(words.end(), {"--stage", std::to_string(i + 1) + ":" + stages[i]});
        }
        words.insert(words.end(), {"-t", slots});
        return run(words);
    };
    const std::string list = succeed({"list", "stages"}).out;
    std::map<std::string, std::vector<std::string>> stagesOf;
    for (std::size_t begin = 0; begin < list.size(); begin = list.find('\n', begin) + 1) {
        const std::size_t tab = list.find('\t', begin), end = list.find('\t', tab + 1);
        stagesOf[list.substr(begin, tab - begin)].push_back(list.substr(tab + 1, end - tab - 1));
    }
    std::size_t stages = 0;
    for (const auto& [technique, all] : stagesOf)
        for (std::size_t first = 0; first < all.size(); first += 4) {
            const auto begin = all.begin() + static_cast<std::ptrdiff_t>(first);
            const std::vector<std::string> group(begin, begin + std::min<std::ptrdiff_t>(4, all.end() - begin));
            if (draw(technique, group).status == 0) {
                stages += group.size();
                continue;
            }
            // A pass may belong to a setting; then the program says so.
            for (const std::string& stage : group) {
                const ProgramResult alone = draw(technique, {stage});
                if (alone.status == 0)
                    ++stages;
                else
                    expectOneLine(alone, 2,
                                  {"pass '" + stage.substr(stage.find(':') + 1) + "'", "does not run with these settings"});
            }
        }
    EXPECT_GT(stages, 100);
}

TEST_F(CaptureTest, SettingsReachTheirSlot) {
    const Words two = {"-t", "shadow-map,shadow-map", "--labels", "false"};
    const auto with = [&](const std::string& setting) {
        Words words = two;
        words.insert(words.end(), {"--set", setting});
        return pixels(words).rgba;
    };
    const auto plain = pixels(two).rgba, first = with("1:shadow-map.resolution=64"),
               second = with("2:shadow-map.resolution=64"), both = with("shadow-map.resolution=64");
    EXPECT_NE(first, plain);
    EXPECT_NE(second, plain);
    EXPECT_NE(first, second);
    // The left half of `both` is that of `first`, the right half that of `second`.
    const auto half = [](const std::vector<std::uint8_t>& rgba, int side) {
        std::vector<std::uint8_t> bytes;
        for (int row = 0; row < 48; ++row)
            for (int i = 0; i < 31 * 4; ++i)
                bytes.push_back(rgba[static_cast<std::size_t>((row * 64 + 33 * side) * 4 + i)]);
        return bytes;
    };
    EXPECT_EQ(half(both, 0), half(first, 0));
    EXPECT_EQ(half(both, 1), half(second, 1));
    EXPECT_EQ(half(first, 1), half(plain, 1));
    // Of two settings of one parameter the later counts.
    EXPECT_EQ(pixels({"-t", "shadow-map", "--set", "shadow-map.filter=hard", "--set", "shadow-map.filter=pcf"}).rgba,
              pixels({"-t", "shadow-map"}).rgba);
}

TEST_F(CaptureTest, PngSaysHowItWasMade) {
    const auto text = decoded(picture({"-t", "shadow-map", "--set", "shadow-map.resolution=128"})).text;
    const auto value = [&](const std::string& key) {
        const auto found = std::ranges::find(text, key, &image::PngText::key);
        return found == text.end() ? std::string() : found->value;
    };
    EXPECT_EQ(value("Scene"), "box");
    EXPECT_EQ(value("Techniques"), "shadow-map");
    EXPECT_NE(value("Settings").find("shadow-map.resolution=128"), std::string::npos);
}

TEST_F(CaptureTest, OptionsInAnyOrderAndForm) {
    const std::string expected = picture({"-t", "shadow-map"});
    for (const Words& arguments :
         {Words{"capture", "-t", "shadow-map", "box.json", "--size=64x48", "--output=y.png"},
          Words{"capture", "--size", "64x48", "-o", "y.png", "-t", "shadow-map", "--", "box.json"},
          Words{"capture", "-oy.png", "--technique=shadow-map", "--size=64x48", "box.json"}}) {
        succeed(arguments);
        EXPECT_EQ(content("y.png"), expected);
        std::filesystem::remove(folder.path() / "y.png");
    }
}

TEST_F(CaptureTest, NamesThatLookLikeOptions) {
    std::filesystem::copy(folder.path() / "box.json", folder.path() / "-x.json");
    succeed({"capture", "--size", "8x8", "--output=-y.png", "--", "-x.json"});
    EXPECT_EQ(headerOf(content("-y.png")).width, 8u);
}

TEST_F(CaptureTest, NamesWithOddBytes) {
    for (const std::string name : {"a b;c:d", "\xc3\xa4\xe2\x82\xac", "\xff\xfe", "line\nfeed"}) {
        std::filesystem::copy(folder.path() / "box.json", folder.path() / (name + ".json"));
        succeed({"capture", name + ".json", "-o", name + ".png", "--size", "8x8", "--stats", name + ".stats.json"});
        EXPECT_EQ(headerOf(content(name + ".png")).width, 8u) << name;
        EXPECT_TRUE(nlohmann::json::accept(content(name + ".stats.json"))) << name;
    }
}

TEST_F(CaptureTest, Stats) {
    succeed({"capture", "box.json", "-o", "x_#.png", "--size", "64x48", "-t", "shadow-map,shadow-volume-zfail",
             "--frames", "3", "--stats", "s.json"});
    const nlohmann::json stats = nlohmann::json::parse(content("s.json"));
    EXPECT_EQ(stats["scene"], "box");
    EXPECT_EQ(stats["size"], nlohmann::json::array({64, 48}));
    EXPECT_FALSE(stats["renderer"].get<std::string>().empty());
    ASSERT_EQ(stats["results"].size(), 2u);
    for (const auto& result : stats["results"]) {
        EXPECT_EQ(result["frames"], 3);
        EXPECT_GT(result["ms"]["frame"].get<double>(), 0);
        EXPECT_GE(result["ms"]["frame"].get<double>(), result["ms"]["prepare"].get<double>());
        EXPECT_GE(result["ms"]["passes"].size(), 2u);
        EXPECT_FALSE(result["counters"].empty());
        EXPECT_FALSE(result["parameters"].empty());
    }
    EXPECT_EQ(stats["results"][0]["technique"], "shadow-map");
}

TEST_F(CaptureTest, StatsSayWhatWasFound) {
    succeed({"capture", "box.json", "-o", "x.png", "--size", "64x48", "-t", "planar", "--stats", "s.json"});
    const nlohmann::json found = nlohmann::json::parse(content("s.json"))["results"][0]["found"];
    ASSERT_GE(found.size(), 3u) << "the floor and two or three sides of the box";
    EXPECT_TRUE(std::ranges::any_of(found, [](const nlohmann::json& one) {
        return one["is"] == "(0, 1, 0)·P + 0 = 0";
    })) << found;
    EXPECT_TRUE(
        std::ranges::any_of(found, [](const nlohmann::json& one) { return one["is"] == "(0, 1, 0)·P - 1 = 0"; }))
        << "the lid; " << found;
}

TEST_F(CaptureTest, StatsAndPicturesToStandardOutput) {
    const ProgramResult stats =
        succeed({"capture", "box.json", "-o", "/dev/null", "--size", "8x8", "--stats", "/dev/stdout"});
    EXPECT_TRUE(nlohmann::json::accept(stats.out));
    EXPECT_EQ(headerOf(succeed({"capture", "box.json", "-o", "/dev/stdout", "--size", "8x8"}).out).width, 8u);
    EXPECT_EQ(newSince({{"box.json", ""}}), Words{});
}

TEST_F(CaptureTest, OrbitsOfLightAndCamera) {
    const std::string plain = picture({});
    for (const std::string orbit : {"--orbit-light", "--orbit-camera"}) {
        const Listing before = listing();
        succeed({"capture", "box.json", "-o", "f_###.png", "--size", "64x48", "--frames", "4", orbit, "360"});
        EXPECT_EQ(newSince(before), (Words{"f_001.png", "f_002.png", "f_003.png", "f_004.png"}));
        EXPECT_EQ(content("f_001.png"), plain) << orbit;
        EXPECT_NE(content("f_002.png"), content("f_001.png"));
        EXPECT_NE(content("f_003.png"), content("f_002.png"));
        // Half way round the other way is half way round.
        succeed({"capture", "box.json", "-o", "g_###.png", "--size", "64x48", "--frames", "2", orbit, "-360"});
        EXPECT_EQ(content("g_002.png"), content("f_003.png")) << orbit;
        for (const std::string& name : newSince(before))
            std::filesystem::remove(folder.path() / name);
    }
}

TEST_F(CaptureTest, PathsOfCameraAndLights) {
    const std::string plain = picture({});
    folder.write("path.json", R"([{"frame": 2}, // the scene as it is, until here
                                  {"frame": 4, "camera": {"position": [-3, 2.5, 6]},
                                               "lights": [{"name": "key", "position": [-2, 5, 3]}]}])");
    const Listing before = listing();
    const Words capture = {"capture", "box.json", "--path", "path.json", "--size", "64x48", "-o"};
    const auto captured = [&](const Words& more) {
        Words words = capture;
        words.insert(words.end(), more.begin(), more.end());
        succeed(words);
    };
    captured({"f_#.png"}); // as many as the path has
    EXPECT_EQ(newSince(before), (Words{"f_1.png", "f_2.png", "f_3.png", "f_4.png"}));
    EXPECT_EQ(content("f_1.png"), plain);
    EXPECT_EQ(content("f_2.png"), plain);
    EXPECT_NE(content("f_3.png"), content("f_2.png"));
    EXPECT_NE(content("f_4.png"), content("f_3.png"));
    captured({"g_#.png", "--frames", "6"}); // and stands still after it
    for (const std::string number : {"1", "2", "3", "4"})
        EXPECT_EQ(content("g_" + number + ".png"), content("f_" + number + ".png"));
    EXPECT_EQ(content("g_5.png"), content("f_4.png"));
    EXPECT_EQ(content("g_6.png"), content("f_4.png"));
    captured({"h.png", "--frames", "1"});
    EXPECT_EQ(content("h.png"), plain);

    // The end of the path is the scene that says the same.
    std::string moved = fileContent(folder.path() / "box.json");
    for (const auto& [from, to] : {std::pair("[-3, 2.5, 4]", "[-3, 2.5, 6]"), std::pair("[2, 5, 3]", "[-2, 5, 3]")}) {
        ASSERT_NE(moved.find(from), std::string::npos);
        moved.replace(moved.find(from), std::string(from).size(), to);
    }
    folder.write("box.json", moved);
    EXPECT_EQ(picture({}), content("f_4.png"));
}

TEST_F(CaptureTest, ScenesWithLittleInThem) {
    const std::string noLights = R"("lights": [])", noObjects = R"("objects": [])";
    folder.write("dark.json", sceneText(kCamera, noLights, kBoxOnFloor));
    folder.write("empty.json", sceneText(kCamera, kTwoLights, noObjects));
    folder.write("nothing.json", sceneText(kCamera, noLights, noObjects));
    for (const std::string technique : {"unshadowed", "shadow-map", "shadow-volume-zfail"})
        for (const auto& [scene, says] : std::map<std::string, Words>{
                 {"dark", {"no lights"}}, {"empty", {"no objects"}}, {"nothing", {"no lights", "no objects"}}}) {
            const ProgramResult result =
                succeed({"capture", scene + ".json", "-o", "x.png", "--size", "64x48", "-t", technique});
            EXPECT_EQ(headerOf(content("x.png")).width, 64u);
            EXPECT_EQ(std::ranges::count(result.err, '\n'), static_cast<long>(says.size())) << result.err;
            for (const std::string& part : says)
                EXPECT_NE(result.err.find(part), std::string::npos) << result.err;
            std::filesystem::remove(folder.path() / "x.png");
        }
    expectRefused({"capture", "dark.json", "-o", "x.png", "--stage", "visibility"}, 2, {"needs a light"});
    expectRefused({"capture", "dark.json", "-o", "x.png", "--light", "key"}, 2, {"it has no lights"});
}

TEST_F(CaptureTest, CameraInsideGeometry) {
    folder.write("inside.json",
                 sceneText(R"("camera": {"position": [0, 0.5, 0], "target": [1, 0.5, 0]})", kTwoLights, kBoxOnFloor));
    for (const std::string technique : {"unshadowed", "shadow-map", "shadow-volume-zfail"}) {
        const ProgramResult result = succeed(
            {"capture", "inside.json", "-o", "x.png", "--size", "32x32", "-t", technique, "--stage", "visibility"});
        EXPECT_EQ(result.err, "");
        // The walls of the box lie between the eye and the lights: nothing it sees is lit.
        const image::Image pixels = decoded(content("x.png")).image;
        if (technique != "unshadowed") {
            EXPECT_EQ(pixels.at(16, 16).r, 0) << technique;
        }
        EXPECT_EQ(pixels.at(16, 16).a, 255) << technique;
    }
}

TEST_F(CaptureTest, SmallPicturesSayWhatIsLeftOut) {
    const ProgramResult result = succeed({"capture", "box.json", "-o", "x.png", "--size", "48x24", "-t",
                                          "shadow-map,shadow-map", "--stage", "comparison"});
    EXPECT_NE(result.err.find("note: the titles would cover the pictures"), std::string::npos) << result.err;
    EXPECT_NE(result.err.find("note: the legends would cover the pictures"), std::string::npos) << result.err;
}

} // namespace
} // namespace shadowlab::testing
