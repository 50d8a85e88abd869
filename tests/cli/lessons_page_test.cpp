// `shadowlab slides lessons` as a user runs it. The page is taken apart again, and held against what `capture` draws and `lesson` measures.
// SPDX-License-Identifier: MIT
#include <nlohmann/json.hpp>

#include "app/context/assets.h"
#include "techniques/foundation/image/webp/webp.h"
#include "tests/cli/command_fixture.h"

namespace shadowlab {
namespace {

using Json = nlohmann::json;

/// What stands between `begin` and `end`, everywhere in a text.
std::vector<std::string> between(const std::string& text, const std::string& begin, const std::string& end) {
    std::vector<std::string> found;
    for (std::size_t at = text.find(begin); at != std::string::npos; at = text.find(begin, at)) {
        at += begin.size();
        const std::size_t stop = text.find(end, at);
        found.push_back(text.substr(at, stop - at));
        at = stop;
    }
    return found;
}

std::string bytesOf(const std::string& base64) {
    static const std::string letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string bytes;
    std::uint32_t bits = 0;
    int count = 0;
    for (const char letter : base64) {
        if (letter == '=') break;
        bits = bits << 6 | static_cast<std::uint32_t>(letters.find(letter));
        if ((count += 6) >= 8) bytes += static_cast<char>(bits >> (count -= 8) & 0xff);
    }
    return bytes;
}

/// A lesson as it stands in the page.
struct Section {
    std::string name, html;
    std::size_t right;
    std::vector<std::string> choices;

    explicit Section(const std::string& section)
        : name(between(section, "data-name=\"", "\"").at(0)), html(section), right(std::stoul(between(section, "data-right=\"", "\"").at(0))),
          choices(between(between(section, "<ol class=\"choices\"", "</ol>").at(0), "<li>", "</li>")) {}

    /// The pictures of a state, "before" or "after", as WebP.
    [[nodiscard]] std::vector<std::string> pictures(const std::string& state) const {
        std::vector<std::string> found;
        for (const std::string& image : between(html, "<img class=\"" + state, ">"))
            found.push_back(bytesOf(between(image, "base64,", "\"").at(0)));
        return found;
    }
    /// As they were measured: before and after, for each quantity.
    [[nodiscard]] std::vector<double> numbers() const {
        std::vector<double> found;
        for (const std::string& number : between(html, "<data value=\"", "\""))
            found.push_back(std::stod(number));
        return found;
    }
};

constexpr const char* kLessons[] = {"acne", "shimmering-cascades", "stencil-overflow"}; ///< in the order of the course

class LessonsPageTest : public testing::CommandTest {
protected:
    [[nodiscard]] testing::ProgramResult page(const std::string& only) const { return run({"slides", "lessons", "-o", "out", "--only", only}); }
    [[nodiscard]] std::string html() const { return testing::fileContent(folder.path() / "out/lessons.html"); }
    [[nodiscard]] std::vector<Section> sections() const {
        std::vector<Section> found;
        for (const std::string& section : between(html(), "<section class=\"lesson", "</section>"))
            found.emplace_back(section);
        return found;
    }
    /// `capture` of the lesson's scene in the page's size, in WebP.
    [[nodiscard]] std::vector<std::string> captured(std::vector<std::string> words, int frames = 1) const {
        words.insert(words.begin(), "capture");
        words.insert(words.end(), {"--size", "768x432", "--labels", "false", "-o", frames > 1 ? "frame_#.png" : "frame_1.png"});
        const testing::ProgramResult result = run(words);
        EXPECT_EQ(result.status, 0) << result.err;
        std::vector<std::string> pictures;
        for (int frame = 1; frame <= frames; ++frame) {
            const std::string png = testing::fileContent(folder.path() / ("frame_" + std::to_string(frame) + ".png"));
            const std::vector<std::uint8_t> webp = image::encodeWebp(testing::decoded(png).image, image::WebpKind::photo);
            pictures.emplace_back(webp.begin(), webp.end());
        }
        return pictures;
    }
};

TEST_F(LessonsPageTest, PicturesChoicesAndNumbersAreThoseOfTheLessons) {
    ASSERT_EQ(page("stencil-overflow,acne,shimmering-cascades").status, 0);
    const std::vector<Section> lessons = sections();
    ASSERT_EQ(lessons.size(), std::size(kLessons));
    const std::string all = html();
    int numbers = 0;
    for (std::size_t i = 0; i < lessons.size(); ++i) {
        const Section& lesson = lessons[i];
        EXPECT_EQ(lesson.name, kLessons[i]) << "lessons stand in the order of the course";
        ASSERT_LT(lesson.right, lesson.choices.size());
        EXPECT_EQ(std::ranges::count(lesson.choices, lesson.choices[lesson.right]), 1);
        const std::string answer = std::string(1, static_cast<char>('A' + lesson.right)) + ": " + lesson.choices[lesson.right];
        EXPECT_NE(lesson.html.find("<p class=\"answer-is\">" + answer + "</p>"), std::string::npos);
        const std::string key = between(all, "<section id=\"key\">", "</section>").at(0);
        EXPECT_NE(key.find("<li>" + answer), std::string::npos) << key;
        const testing::ProgramResult measured = run({"lesson", lesson.name, "--json"});
        ASSERT_EQ(measured.status, 0) << measured.err;
        std::vector<double> expected;
        const Json json = Json::parse(measured.out);
        for (const Json& one : json["expectations"])
            for (const char* state : {"before", "after"})
                expected.push_back(one[state]["value"]);
        EXPECT_EQ(lesson.numbers(), expected) << lesson.name;
        EXPECT_NE(lesson.html.find(": " + json["title"].get<std::string>() + "</span>"), std::string::npos);
        numbers += static_cast<int>(expected.size());
    }
    EXPECT_GE(numbers, 6);
    const std::vector<std::string> acne{"still-life", "-t", "shadow-map", "--set", "shadow-map.resolution=512", "--set", "shadow-map.filter=hard", "--set"};
    const auto with = [](std::vector<std::string> words, const std::vector<std::string>& more) {
        words.insert(words.end(), more.begin(), more.end());
        return words;
    };
    EXPECT_EQ(lessons[0].pictures("before"), captured(with(acne, {"shadow-map.bias-mode=none"})));
    EXPECT_EQ(lessons[0].pictures("after"), captured(with(acne, {"shadow-map.bias-mode=receiver-plane"})));
    EXPECT_NE(lessons[0].pictures("before"), lessons[0].pictures("after"));
    const std::string sheets = (context::assetsRoot() / "lessons/scenes/four-sheets.json").string();
    EXPECT_EQ(lessons[2].pictures("before"), captured({sheets, "-t", "shadow-volume-zfail", "--set", "shadow-volume-zfail.stencil-bits=2"}));
    EXPECT_EQ(lessons[2].pictures("after"), captured({sheets, "-t", "shadow-volume-zfail", "--set", "shadow-volume-zfail.stencil-bits=8"}));
    EXPECT_EQ(lessons[2].html.find(" asks-after"), 0u) << "the fault would give the answer away";
    EXPECT_NE(lessons[0].html.find(" asks-after"), 0u);
    EXPECT_EQ(lessons[1].pictures("before").size(), 6u); // the frames of its motion
    EXPECT_NE(lessons[1].pictures("before")[0], lessons[1].pictures("before")[5]);
    EXPECT_EQ(lessons[1].pictures("after").size(), 6u);
}

TEST_F(LessonsPageTest, NothingBeforeTheAnswerGivesItAway) {
    ASSERT_EQ(page("acne,stencil-overflow").status, 0);
    const std::vector<Section> lessons = sections();
    ASSERT_EQ(lessons.size(), 2u);
    const std::string all = html(), overview = between(all, "<nav id=\"overview\"", "</nav>").at(0);
    for (const char* title : {"acne", "Four shadows"})
        EXPECT_EQ(overview.find(title), std::string::npos) << title;
    const std::vector<std::string> alternatives = between(lessons[0].html, " alt=\"", "\"");
    ASSERT_EQ(alternatives.size(), 2u);
    EXPECT_NE(alternatives[0].find("stripes on a lit table"), std::string::npos) << "what is seen is told";
    EXPECT_EQ(alternatives[0].find("acne"), std::string::npos) << "what it is called is not";
    for (const std::string& alternative : between(lessons[1].html, " alt=\"", "\""))
        EXPECT_EQ(alternative.find("four"), std::string::npos) << alternative;
}

TEST_F(LessonsPageTest, ThePageNeedsNoOtherFileAndIsTheSameAgain) {
    ASSERT_EQ(page("acne").status, 0);
    const Listing once = listing();
    EXPECT_EQ(std::ranges::count_if(once, [](const auto& file) { return file.first.starts_with("out/"); }), 1) << "lessons.html alone";
    ASSERT_EQ(page("acne").status, 0);
    EXPECT_TRUE(listing() == once);
    const std::string all = html();
    EXPECT_GT(all.size(), 20000u);
    for (const std::string& name : between(all, "http://", "'"))
        EXPECT_EQ(name, "www.w3.org/2000/svg") << "a name, which is not loaded";
    for (const char* other : {"https://", "src=\"lessons", "<link", "@import", "fetch(", "XMLHttpRequest"})
        EXPECT_EQ(all.find(other), std::string::npos) << other;
    EXPECT_EQ(all.find(context::assetsRoot().string()), std::string::npos) << "a path of this machine";
}

TEST_F(LessonsPageTest, WhatIsRefusedLeavesNothing) {
    const Listing before = listing();
    expectOneLine(page("acnee"), 2, {"no lesson is called 'acnee'", "acne"});
    folder.write("lessons.json", R"({"title": "A", "scene": "box.json", "slides": [{"name": "a", "title": "A", "slots": [{"technique": "planar"}], "alt": "A."}]})");
    expectOneLine(run({"slides", "lessons", "lessons.json", "-o", "out"}), 2, {"lessons.json", "two folders"});
    EXPECT_EQ(newSince(before), std::vector<std::string>{"lessons.json"});
    std::filesystem::create_directories(folder.path() / "out/lessons.html"); // in its way
    expectOneLine(page("acne"), 4, {"lessons.html"});
    EXPECT_EQ(newSince(before).size(), 3u) << "lessons.json, out, out/lessons.html";
}

/// Assets with one deck and two lessons, so that all of them are soon drawn.
class SmallCourseTest : public LessonsPageTest {
protected:
    SmallCourseTest() {
        folder.write("assets/decks/tiny.json", R"({"title": "A deck", "scene": "sphere-on-plane", "slides":
            [{"name": "ball", "title": "A ball", "slots": [{"technique": "planar"}], "alt": "A ball."}]})");
        for (const auto& entry : std::filesystem::directory_iterator(context::assetsRoot()))
            if (const std::string name = entry.path().filename().string(); name != "decks" && name != "lessons")
                std::filesystem::create_symlink(entry.path(), folder.path() / "assets" / name);
        for (const char* name : {"steps", "stripes"})
            folder.write("assets/lessons/" + std::string(name) + ".json", R"({"title": ")" + std::string(name) + R"(", "scene": "sphere-on-plane",
                "slots": [{"technique": "shadow-map"}], "set": ["shadow-map.filter=hard"], "before": {"set": ["shadow-map.resolution=64"]},
                "after": {"set": ["shadow-map.resolution=2048"]}, "happens": "H.", "mends": "M.", "look": [{"box": [0.2, 0.4, 0.3, 0.3], "label": "here"}],
                "expect": [{"quantity": "edgeErrorPx", "before": {"atLeast": 0.1}, "after": {"atMost": 0.02}}]})");
    }
    [[nodiscard]] testing::ProgramResult slides(const std::vector<std::string>& words) const {
        std::vector<std::string> all{"slides", "-o", "out", "--size", "640x360"};
        all.insert(all.end(), words.begin(), words.end());
        return run(all, {.environment = {{"SHADOWLAB_ASSETS", (folder.path() / "assets").string()}}});
    }
};

TEST_F(SmallCourseTest, ItIsWrittenWhereItIsNamedAndWithAllDecksToExplore) {
    struct Case {
        std::vector<std::string> words;
        bool hasDeck, hasLessons;
    };
    for (const auto& [words, hasDeck, hasLessons] : {Case{{"lessons"}, false, true}, Case{{"tiny", "lessons"}, true, true}, Case{{"--explore"}, true, true},
                                                     Case{{}, true, false}, Case{{"tiny", "--explore"}, true, false}}) {
        const testing::ProgramResult result = slides(words);
        ASSERT_EQ(result.status, 0) << result.err;
        const Listing found = listing();
        EXPECT_EQ(found.contains("out/tiny.html"), hasDeck) << ::testing::PrintToString(words);
        EXPECT_EQ(found.contains("out/pictures"), hasDeck) << ::testing::PrintToString(words);
        EXPECT_EQ(found.contains("out/lessons.html"), hasLessons) << ::testing::PrintToString(words);
        EXPECT_FALSE(found.contains("out/tiny.unfinished.json"));
        if (hasLessons) {
            EXPECT_EQ(sections().size(), 2u);
        }
        std::filesystem::remove_all(folder.path() / "out");
    }
}

TEST_F(SmallCourseTest, WhenALessonFailsTheDecksStand) {
    folder.write("assets/lessons/broken.json", R"({"title": "T", "happens": "H.", "mends": "M."})");
    const testing::ProgramResult result = slides({"--explore"});
    EXPECT_EQ(result.status, 3);
    EXPECT_NE(result.err.find("broken.json"), std::string::npos) << result.err;
    EXPECT_FALSE(listing().contains("out/lessons.html"));
    std::filesystem::remove(folder.path() / "assets/lessons/broken.json");
    const testing::ProgramResult again = slides({"--explore"});
    EXPECT_EQ(again.status, 0) << again.err;
    EXPECT_NE(again.err.find("1 of 1 slides were there already"), std::string::npos) << again.err;
    EXPECT_EQ(sections().size(), 2u);
}

} // namespace
} // namespace shadowlab
