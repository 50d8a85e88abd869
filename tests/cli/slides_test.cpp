// `shadowlab slides` as a user runs it: what it writes, what it says of a slide that fails, and that it writes it again.
// SPDX-License-Identifier: MIT
#include <cstdio>

#include "tests/cli/command_fixture.h"

namespace shadowlab {
namespace {

class SlidesTest : public testing::CommandTest {
protected:
    SlidesTest() {
        folder.write("deck.json", R"({"title": "A deck", "scene": "box.json", "slots": [{"technique": "shadow-map"}],
  "slides": [
    {"name": "box", "title": "A box", "slots": [{"technique": "shadow-volume"}], "alt": "A box & its shadow.",
     "callouts": [{"box": [0.3, 0.3, 0.4, 0.4], "label": "box"}], "caption": "It stands on the floor, $n_f$ times.", "notes": ["Say what it stands on.", "Ask: <where>?"]},
    {"name": "broken", "title": "Broken", "slots": [{"technique": "shadow-map"}], "stage": "nothing", "alt": "-"},
    {"name": "words", "title": "Words", "text": ["No picture."], "formulas": ["\\frac{1}{2}"]},
    {"name": "drawing", "title": "A drawing", "slots": [{"technique": "shadow-volume"}], "diagram": "pixel",
     "pixel": [0.5, 0.5], "alt": "Faces on a line."}]})");
    }
    [[nodiscard]] testing::ProgramResult slides(std::vector<std::string> more = {}) const {
        std::vector<std::string> words{"slides", "deck.json", "-o", "out", "--size", "640x360", "--supersample", "1"};
        words.insert(words.end(), more.begin(), more.end());
        return run(words);
    }
    [[nodiscard]] std::string out(const std::string& name) const {
        return testing::fileContent(folder.path() / "out" / name);
    }
};

TEST_F(SlidesTest, AFailingSlideNamesItselfAndTheOthersComeOut) {
    const testing::ProgramResult result = slides();
    EXPECT_EQ(result.status, 3);
    EXPECT_NE(result.err.find("deck.json:5:"), std::string::npos) << result.err;
    EXPECT_NE(result.err.find("slide 'broken'"), std::string::npos) << result.err;
    EXPECT_EQ(std::ranges::count(result.err, '\n'), 1) << result.err;
    for (const char* name : {"deck-01-box.png", "deck-03-words.png", "deck-04-drawing.png"}) {
        const testing::PngHeader header = testing::headerOf(out(name));
        EXPECT_EQ(header.width, 640u) << name;
        EXPECT_EQ(header.height, 360u) << name;
    }
    EXPECT_TRUE(out("deck-02-broken.png").empty());
    EXPECT_FALSE(out("pictures/deck-01-box.png").empty());
    EXPECT_TRUE(out("pictures/deck-03-words.png").empty()) << "it has no pictures";
}

TEST_F(SlidesTest, PagesHoldAllThatWasDrawn) {
    static_cast<void>(slides());
    const std::string html = out("deck.html"), text = out("deck.md");
    std::size_t pictures = 0;
    for (std::size_t at = html.find("data:image/png;base64,"); at != std::string::npos;
         at = html.find("data:image/png;base64,", at + 1))
        ++pictures;
    EXPECT_EQ(pictures, 3u);
    EXPECT_NE(html.find("alt=\"A box &amp; its shadow.\""), std::string::npos);
    EXPECT_NE(html.find("It stands on the floor, <math><mrow><msub>"), std::string::npos) << "a formula among words is set";
    EXPECT_NE(html.find("<div class=\"formula\"><math display=\"block\"><mrow><mfrac>"), std::string::npos);
    EXPECT_EQ(html.find("http"), std::string::npos) << "it needs nothing from elsewhere";
    EXPECT_NE(html.find("<div class=\"notes\"><p>Say what it stands on.</p><p>Ask: &lt;where&gt;?</p></div>"), std::string::npos);
    EXPECT_NE(text.find("::: notes\nSay what it stands on"), std::string::npos);
    // The line of keys names each that does something special, and the script knows it.
    for (const char* key : {"f", "b", "n", "c", "o", "h"}) {
        EXPECT_NE(html.find("<kbd>" + std::string(key) + "</kbd>"), std::string::npos) << key;
        EXPECT_NE(html.find(" " + std::string(key) + ": "), std::string::npos) << key;
    }
    EXPECT_NE(html.find("showKeys(true);"), std::string::npos) << "visible from the start";
    EXPECT_NE(html.find("'.': dark"), std::string::npos) << "what the remote of a presenter sends";
    // A phone shows the part of a slide that its pictures fill, so that no title and no word is read twice.
    for (const char* name : {"box", "drawing"}) {
        const std::size_t at = html.find("<section id=\"" + std::string(name) + "\"");
        ASSERT_NE(at, std::string::npos);
        const std::size_t place = html.find("<div class=\"sheet\" style=\"--left: ", at);
        ASSERT_LT(place, html.find("</section>", at)) << name;
        double left = 0, top = 0, wide = 0, high = 0, shape = 0;
        ASSERT_EQ(std::sscanf(html.c_str() + html.find("--left", place),
                              "--left: %lf; --top: %lf; --wide: %lf; --high: %lf; --shape: %lf", &left, &top, &wide, &high, &shape),
                  5);
        EXPECT_GT(top, 48.0 / 1080) << "below the title, whose letters are 48 of 1080 high";
        EXPECT_LE(left + wide, 1.0);
        EXPECT_LE(top + high, 1.0);
        EXPECT_NEAR(shape, 16.0 / 9 * wide / high, 0.001); // of five digits after the point
    }
    EXPECT_NE(html.find("<div class=\"sheet wordy\">", html.find("<section id=\"words\"")), std::string::npos);
    EXPECT_NE(text.find("# A box\n"), std::string::npos);
    EXPECT_NE(text.find("(pictures/deck-01-box.png)"), std::string::npos);
    EXPECT_NE(text.find("![](pictures/deck-03-words-with-words.png)"), std::string::npos)
        << "a formula, as it is drawn";
    EXPECT_FALSE(out("pictures/deck-03-words-with-words.png").empty());
    EXPECT_NE(text.find("$$\\frac{1}{2}$$"), std::string::npos);
}

TEST_F(SlidesTest, SameDeckSameBytes) {
    static_cast<void>(slides());
    const Listing first = listing();
    EXPECT_GE(first.size(), 8u);
    static_cast<void>(slides());
    EXPECT_EQ(listing(), first);
}

TEST_F(SlidesTest, OneSlideAloneAndRefusals) {
    const testing::ProgramResult one = slides({"--only", "words"});
    EXPECT_EQ(one.status, 0) << one.err;
    EXPECT_FALSE(out("deck-03-words.png").empty());
    EXPECT_TRUE(out("deck.html").empty());
    expectRefused({"slides", "deck.json"}, 2, {"-o"});
    expectRefused({"slides", "deck.json", "-o", "out", "--only", "wrds"}, 2, {"words"});
    expectRefused({"slides", "gone.json", "-o", "out"}, 3, {"gone.json"});
    expectRefused({"slides", "shadws", "-o", "out"}, 3, {"shadows"});
    expectRefused({"slides", "deck.json", "-o", "box.json"}, 4, {"box.json"});
    expectRefused({"slides", "deck.json", "-o", "out", "--size", "64x36"}, 2, {"360"});
}

} // namespace
} // namespace shadowlab
