// `shadowlab slides --explore` as a user runs it. What the page shows is taken out of it again, and held against what `capture` draws and
// `measure` finds of the same scene with the lamp at the same place.
// SPDX-License-Identifier: MIT
#include <zlib.h>

#include <nlohmann/json.hpp>
#include <random>

#include "app/course/explore/picture_pack.h"
#include "techniques/foundation/base/look.h"
#include "tests/cli/command_fixture.h"
#include "tests/support/webp_tiles.h"

namespace shadowlab {
namespace {

using Json = nlohmann::json;

/// An explorable slide, as a browser finds it in the page.
struct ExploredPage {
    Json data;
    std::string pack; ///< base64

    ExploredPage(const std::string& html, const std::string& slide) {
        std::string json = element(html, "<script type=\"application/json\" id=\"explore-" + slide + "\">");
        for (std::size_t at = json.find("<\\/"); at != std::string::npos; at = json.find("<\\/", at)) json.erase(at + 1, 1);
        data = Json::parse(json);
        pack = element(html, "<script type=\"text/plain\" id=\"pack-" + slide + "\">");
    }
    /// The bytes of a piece, of whose base64 no more is read than its own.
    [[nodiscard]] std::string bytes(std::size_t offset, std::size_t length) const {
        static const std::string letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
        EXPECT_EQ(offset % 3, 0u);
        std::string found;
        std::uint32_t bits = 0;
        for (std::size_t i = offset / 3 * 4; found.size() < length; ++i) {
            const std::size_t value = std::min(letters.find(pack.at(i)), std::size_t{64}) % 64; // '=' stands for nothing
            bits = bits << 6 | static_cast<std::uint32_t>(value);
            if (i % 4 == 3)
                for (const int shift : {16, 8, 0})
                    if (found.size() < length) found += static_cast<char>(bits >> shift & 0xff);
        }
        return found;
    }
    [[nodiscard]] std::string sheetBytes(const Json& sheet) const { return bytes(sheet[0], sheet[1]); }

    /// The tiles of a map by place; -1: none.
    [[nodiscard]] std::vector<int> tiles(int map) const {
        std::vector<int> ids;
        const Json& runs = data["maps"][static_cast<std::size_t>(map)];
        for (std::size_t i = 0; i < runs.size(); i += 2)
            for (int k = 0; k < runs[i + 1].get<int>(); ++k)
                ids.push_back(runs[i] < 0 ? -1 : runs[i].get<int>() + k);
        return ids;
    }
    /// A picture put together from its tiles.
    [[nodiscard]] image::Image picture(int map) const {
        const std::vector<int> ids = tiles(map);
        std::vector<testing::TileSheet> sheets;
        for (const Json& sheet : data["sheets"]) {
            const int first = sheet[2], count = sheet[3];
            if (std::ranges::none_of(ids, [&](int id) { return id >= first && id < first + count; })) continue;
            const std::string bytes = sheetBytes(sheet);
            sheets.push_back({testing::decodedWebp({reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()}), first, count, sheet[4], sheet[5]});
        }
        return testing::fromTiles({data["width"], data["height"]}, data["tile"], ids, sheets);
    }

private:
    static std::string element(const std::string& html, const std::string& begin) {
        const std::size_t at = html.find(begin);
        if (at == std::string::npos) throw std::runtime_error("no " + begin);
        const std::size_t from = at + begin.size();
        return html.substr(from, html.find("</script>", from) - from);
    }
};

constexpr int kPositions = 3, kSamples = 2;
constexpr int kAboveLegend = 340; ///< rows of a picture of 432, above the key of its colours

class ExploreTest : public testing::CommandTest {
protected:
    ExploreTest() {
        folder.write("deck.json", deck(R"({"lamp": 3, "settings": {"shadow-map.resolution": [64, 2048]}, "ask": 8,
         "task": {"question": "Where is it wrong?", "number": "coreErrors", "at-least": 1}})"));
    }
    [[nodiscard]] static std::string deck(const std::string& explore, const std::string& more = "") {
        return R"({"title": "A deck", "scene": "box.json", "slides": [
  {"name": "box", "title": "A box", "slots": [{"technique": "shadow-map"}, {"technique": "shadow-volume-zfail"}],
   "set": ["shadow-map.filter=hard"], )" + more + R"("explore": )" + explore + R"(, "alt": "A box."},
  {"name": "still", "title": "A picture", "slots": [{"technique": "shadow-map"}], "alt": "A box."}]})";
    }
    [[nodiscard]] testing::ProgramResult slides(std::vector<std::string> more = {"--explore"}) const {
        std::vector<std::string> words{"slides", "deck.json", "-o", "out", "--size", "640x360", "--supersample", "2"};
        words.insert(words.end(), more.begin(), more.end());
        return run(words);
    }
    [[nodiscard]] std::string out(const std::string& name) const { return testing::fileContent(folder.path() / "out" / name); }

    /// The frames that `capture` draws while the lights go round.
    [[nodiscard]] std::vector<image::Image> captured(const std::string& technique, const std::vector<std::string>& settings, const Json& data,
                                                     const std::vector<std::string>& more, const std::string& scene = "box.json") const {
        std::vector<std::string> words{"capture", scene, "-o", "frame_##.png", "-t", technique, "--frames", std::to_string(kPositions),
                                       "--orbit-light", "360", "--labels", "false", "--size",
                                       std::to_string(data["width"].get<int>()) + "x" + std::to_string(data["height"].get<int>())};
        for (const std::string& setting : settings)
            words.insert(words.end(), {"--set", technique + "." + setting});
        words.insert(words.end(), more.begin(), more.end());
        const testing::ProgramResult result = run(words);
        EXPECT_EQ(result.status, 0) << result.err;
        std::vector<image::Image> frames;
        for (int frame = 1; frame <= kPositions; ++frame)
            frames.push_back(testing::decoded(testing::fileContent(folder.path() / ("frame_0" + std::to_string(frame) + ".png"))).image);
        return frames;
    }
    /// How many sheets of tiles belong to the picture of that state alone. Each is expected to have the bytes of the captured picture's.
    static int comparedSheets(const ExploredPage& page, const Json& state, const image::Image& capture) {
        const std::vector<int> ids = page.tiles(state["picture"]);
        int sheets = 0;
        for (const Json& sheet : page.data["sheets"]) {
            const int first = sheet[2], count = sheet[3];
            std::vector<int> places;
            for (int id = first; id < first + count; ++id)
                if (const auto found = std::ranges::find(ids, id); found != ids.end()) places.push_back(static_cast<int>(found - ids.begin()));
            if (static_cast<int>(places.size()) != count) continue; // another state has drawn it
            const std::vector<std::uint8_t> expected =
                image::encodeWebp(course::sheetOf(capture, places, sheet[4], sheet[5]), image::WebpKind::photo);
            EXPECT_EQ(page.sheetBytes(sheet), std::string(expected.begin(), expected.end())) << state;
            ++sheets;
        }
        return sheets;
    }
    /// Of the map's pane as the states have them: its technique, and settings beyond the deck's own.
    static std::pair<std::string, std::vector<std::string>> slotOf(const Json& data, const Json& state) {
        if (state["pane"] == 1) return {"shadow-volume-zfail", {}};
        const Json& setting = data["settings"][0];
        const std::size_t value = data["variants"][state["variant"].get<std::size_t>()][0];
        return {"shadow-map", {"filter=hard", "resolution=" + setting["values"][value].get<std::string>()}};
    }
};

TEST_F(ExploreTest, PicturesAreThoseOfCaptureByteByByte) {
    ASSERT_EQ(slides().status, 0);
    const ExploredPage page(out("deck.html"), "box");
    const Json& states = page.data["states"];
    // The map has two resolutions, of which the slide has the second; the volume's pictures stand for both.
    ASSERT_EQ(states.size(), 2u * 2 * kPositions);
    std::map<std::string, std::vector<image::Image>> frames;
    int sheets = 0;
    std::mt19937 dice(20);
    for (int i = 0; i < 12; ++i) {
        const Json& state = states[dice() % states.size()];
        const auto [technique, settings] = slotOf(page.data, state);
        const std::string key = technique + (settings.empty() ? "" : settings.back());
        if (!frames.contains(key))
            frames[key] = captured(technique, settings, page.data, {"--supersample", std::to_string(kSamples)});
        sheets += comparedSheets(page, state, frames[key][state["lamp"].get<std::size_t>()]);
    }
    EXPECT_GE(sheets, 4) << "nothing was compared";
}

/// A slide may look elsewhere than its scene does. Lights that turned about what the scene's own camera looks at would stand elsewhere.
TEST_F(ExploreTest, LightsTurnAboutWhatTheSlideLooksAt) {
    constexpr const char* kSeen = R"("camera": {"position": [4, 3, 3], "target": [1, 0.25, -0.5]})";
    folder.write("deck.json", deck(R"({"lamp": 3, "steps": false, "ask": 0})", std::string(kSeen) + ", "));
    folder.write("seen.json", testing::sceneText(kSeen, testing::kTwoLights, testing::kBoxOnFloor));
    ASSERT_EQ(slides().status, 0);
    const ExploredPage page(out("deck.html"), "box");
    const std::vector<image::Image> frames =
        captured("shadow-volume-zfail", {}, page.data, {"--supersample", std::to_string(kSamples)}, "seen.json");
    int sheets = 0;
    for (const Json& state : page.data["states"])
        if (state["pane"] == 1) sheets += comparedSheets(page, state, frames[state["lamp"].get<std::size_t>()]);
    EXPECT_GE(sheets, kPositions);
    dvec3 middle(0);
    for (const Json& position : page.data["lamp"]["positions"])
        for (int axis = 0; axis < 3; ++axis)
            middle[axis] += position["at"][static_cast<std::size_t>(axis)].get<double>() / kPositions;
    EXPECT_NEAR(middle.x, 1, 1e-9) << "three places a third of a turn apart";
    EXPECT_NEAR(middle.z, -0.5, 1e-9);
}

TEST_F(ExploreTest, VerdictsAndNumbersAreThoseOfMeasure) {
    ASSERT_EQ(slides().status, 0);
    const ExploredPage page(out("deck.html"), "box");
    int wrong = 0;
    for (const Json& state : page.data["states"]) {
        if (state["lamp"] != 0) continue;
        const auto [technique, settings] = slotOf(page.data, state);
        std::vector<std::string> words{"measure", "box.json", "-t", technique, "--json", "--size",
                                       std::to_string(page.data["width"].get<int>()) + "x" + std::to_string(page.data["height"].get<int>())};
        for (const std::string& setting : settings)
            words.insert(words.end(), {"--set", technique + "." + setting});
        const testing::ProgramResult result = run(words);
        ASSERT_EQ(result.status, 0) << result.err;
        const Json measured = Json::parse(result.out)["results"][0];
        const Json& numbers = state["numbers"];
        for (const char* number : {"coreErrors", "falseLit", "falseShadow", "edgeErrorPx"})
            EXPECT_EQ(numbers[number], measured[number]) << number << " of " << technique;
        EXPECT_GT(numbers["compared"], 10000);
        // Every wrong pixel has its own colour in the layer, in which some stand for their neighbours as well.
        const image::Image verdicts = page.picture(state["verdict"]);
        const image::Image captured = this->captured(technique, settings, page.data, {"--stage", "error"}).front();
        const image::Color8 falseLit = image::encoded(look::kFalseLit), falseShadow = image::encoded(look::kFalseShadow);
        int found = 0;
        for (int y = 0; y < captured.height; ++y)
            for (int x = 0; x < captured.width; ++x)
                if (y < kAboveLegend && (captured.at(x, y) == falseLit || captured.at(x, y) == falseShadow)) {
                    ++found;
                    ASSERT_EQ(verdicts.at(x, y), captured.at(x, y)) << x << ", " << y;
                }
        const int all = numbers["falseLit"].get<int>() + numbers["falseShadow"].get<int>();
        EXPECT_LE(found, all);
        EXPECT_GE(found, all / 2);
        wrong += all;
    }
    EXPECT_GT(wrong, 100) << "of 64 texels many have to be wrong, or nothing was shown";
}

TEST_F(ExploreTest, AnswersAreThoseOfProbe) {
    ASSERT_EQ(slides().status, 0);
    const ExploredPage page(out("deck.html"), "box");
    const Json &points = page.data["ask"]["points"], &answers = page.data["ask"]["answers"];
    EXPECT_EQ(answers.size(), 2 * 3 * points.size()) << "of two techniques, with the lamp at three places";
    EXPECT_GE(points.size(), 6u);
    int figures = 0;
    for (const Json& place : answers) {
        const std::string packed = page.bytes(place[3], place[4]);
        std::string text(1 << 22, '\0');
        uLongf length = text.size();
        ASSERT_EQ(uncompress(reinterpret_cast<Bytef*>(text.data()), &length, reinterpret_cast<const Bytef*>(packed.data()), packed.size()), Z_OK);
        const Json answer = Json::parse(text.substr(0, length));
        if (place[1] != 0 || place[2] != 4) continue; // `probe` has the lamp where the scene has it
        const Json& point = points[place[2].get<std::size_t>()];
        const int x = static_cast<int>(point[0].get<double>() * page.data["width"].get<int>());
        const int y = static_cast<int>(point[1].get<double>() * page.data["height"].get<int>());
        const bool isMap = place[0] == 0;
        std::vector<std::string> words{"probe", "box.json", "--pixel", std::to_string(x) + "," + std::to_string(y), "--json", "-t",
                                       isMap ? "shadow-map" : "shadow-volume-zfail", "--diagram", "figure.svg", "--size",
                                       std::to_string(page.data["width"].get<int>()) + "x" + std::to_string(page.data["height"].get<int>())};
        if (isMap) words.insert(words.end(), {"--set", "shadow-map.filter=hard"});
        const testing::ProgramResult result = run(words);
        ASSERT_EQ(result.status, 0) << result.err;
        EXPECT_EQ(answer["verdict"], Json::parse(result.out)["verdict"]);
        EXPECT_EQ(answer["figure"], testing::fileContent(folder.path() / "figure.svg"));
        EXPECT_GT(answer["facts"].size(), 5u);
        ++figures;
    }
    EXPECT_EQ(figures, 2);
}

TEST_F(ExploreTest, AgainAndInterruptedItHasTheSameBytes) {
    ASSERT_EQ(slides().status, 0);
    const Listing once = listing();
    EXPECT_TRUE(once.contains("out/deck.times.json"));
    EXPECT_FALSE(once.contains("out/deck.unfinished.json"));
    for (const auto& [name, content] : once)
        EXPECT_EQ(name.find(".explored."), std::string::npos) << name << " was to be taken away";
    ASSERT_EQ(slides().status, 0);
    EXPECT_TRUE(listing() == once) << "with the times of frames that were measured before all bytes are the same";
    // The second slide cannot be written, since a folder has its name: the first one stands.
    std::filesystem::remove(folder.path() / "out/deck.html");
    std::filesystem::remove(folder.path() / "out/deck-02-still.png");
    std::filesystem::create_directories(folder.path() / "out/deck-02-still.png");
    EXPECT_EQ(slides().status, 4);
    EXPECT_FALSE(out("deck-01-box.explored.html").empty());
    std::filesystem::remove(folder.path() / "out/deck-02-still.png");
    const testing::ProgramResult rest = slides();
    EXPECT_EQ(rest.status, 0);
    EXPECT_NE(rest.err.find("1 of 2 slides were there already"), std::string::npos) << rest.err;
    EXPECT_TRUE(listing() == once);
}

TEST_F(ExploreTest, WithoutTheOptionSlidesArePictures) {
    folder.write("deck.json", deck(R"({"lamp": 1, "steps": false, "ask": 0})"));
    ASSERT_EQ(slides().status, 0);
    const std::string labs = out("deck.html");
    EXPECT_NE(labs.find("data:image/webp;base64,"), std::string::npos) << "stills of a page for phones are small";
    EXPECT_EQ(labs.find("data:image/png;base64,"), std::string::npos);
    std::filesystem::remove_all(folder.path() / "out");
    ASSERT_EQ(slides({}).status, 0);
    const std::string html = out("deck.html");
    EXPECT_NE(html.find("data:image/png;base64,"), std::string::npos);
    EXPECT_EQ(html.find("explorable"), std::string::npos);
    EXPECT_FALSE(listing().contains("out/deck.times.json"));
}

TEST_F(ExploreTest, ABudgetIsKeptAndSaysWhatItChose) {
    folder.write("deck.json", deck(R"({"lamp": 16, "ask": 40})"));
    const testing::ProgramResult result = slides({"--explore-budget", "0.25"});
    ASSERT_EQ(result.status, 0) << result.err;
    EXPECT_NE(result.err.find("slide 'box': "), std::string::npos) << result.err;
    EXPECT_NE(result.err.find(" of 16 positions of the lamp"), std::string::npos) << result.err;
    const ExploredPage page(out("deck.html"), "box");
    EXPECT_LE(page.pack.size() + page.data.dump().size(), 250000u);
    EXPECT_GE(page.data["lamp"]["positions"].size(), 4u);
    EXPECT_LT(page.data["lamp"]["positions"].size(), 16u);
}

TEST_F(ExploreTest, IsOfWholeDecks) {
    const testing::ProgramResult result = slides({"--explore", "--only", "box"});
    EXPECT_EQ(result.status, 2);
    EXPECT_NE(result.err.find("--only"), std::string::npos) << result.err;
    EXPECT_FALSE(listing().contains("out"));
}

struct BadExplore {
    const char *explore, *said;
};
TEST_F(ExploreTest, WhatADeckMayNotSayNamesItsPlace) {
    for (const auto& [explore, said] : {
             BadExplore{R"({"lamps": 3})", "\"lamps\""},
             BadExplore{R"({"lamp": 0})", "\"lamp\""},
             BadExplore{R"({"degrees": 0})", "\"degrees\""},
             BadExplore{R"({"settings": {"resolution": [64, 128]}})", "\"shadow-map.resolution\""},
             BadExplore{R"({"settings": {"shadow-map.resolutio": [64, 128]}})", "resolution"},
             BadExplore{R"({"settings": {"shadow-map.resolution": [64, 1]}})", "64..32768"},
             BadExplore{R"({"settings": {"shadow-map.resolution": [64, 64]}})", "twice"},
             BadExplore{R"({"settings": {"shadow-map.resolution": [64]}})", "2 to 8"},
             BadExplore{R"({"settings": {"planar.darkness": [0, 1]}})", "planar"},
             BadExplore{R"({"stages": ["light-dept"]})", "light-depth"},
             BadExplore{R"({"task": {"question": "Where?", "number": "coreErrors"}})", "at-least"},
             BadExplore{R"({"task": {"question": "Where?", "number": "errors", "at-least": 1}})", "coreErrors"},
             BadExplore{R"({"task": {"question": "Where $?", "number": "coreErrors", "at-least": 1}})", "$"},
             BadExplore{R"({"task": {"question": "Where?", "number": "coreErrors", "at-least": 10, "at-most": 5}})", "at-most"},
             BadExplore{R"({"errors": false, "task": {"question": "Where?", "number": "coreErrors", "at-least": 1}})", "errors"},
             BadExplore{R"("yes")", "explore"},
         }) {
        folder.write("deck.json", deck(explore));
        const testing::ProgramResult result = slides();
        EXPECT_EQ(result.status, 3) << explore;
        EXPECT_EQ(result.err.find("shadowlab: deck.json:"), 0u) << result.err;
        EXPECT_NE(result.err.find(said), std::string::npos) << explore << "\n" << result.err;
        EXPECT_EQ(std::ranges::count(result.err, '\n'), 1) << result.err;
    }
}

} // namespace
} // namespace shadowlab
