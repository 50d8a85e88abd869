// The reader of decks: the built-in ones, what a file may say, and every fault with its line and column.
// SPDX-License-Identifier: MIT
#include "app/course/deck.h"

#include <gtest/gtest.h>

#include "app/context/assets.h"
#include "app/drawing/formula.h"
#include "techniques/foundation/base/error.h"
#include "tests/foundation/scene/scene_files.h"

namespace shadowlab::course {
namespace {

const scene::LoadOptions kLoading{.assetsRoot = context::assetsRoot(), .allowed = {}, .limits = {}};

constexpr const char* kDeck = R"({
  "title": "T", "scene": "still-life",
  "set": ["shadow-map.resolution=512"],
  "slides": [
    {"name": "one", "title": "First", "slots": [{"technique": "shadow-map"}], "pixel": [0.5, 0.5],
     "callouts": [{"box": [0.1, 0.2, 0.3, 0.4], "label": "here"}, {"from": [0, 0], "to": [0.5, 0.5]}],
     "alt": "A."},
    {"name": "two", "title": "Second", "slots": [{"technique": "shadow-map"}], "alt": "B.",
     "pictures": [{"label": "left"}, {"stage": "light-depth", "set": ["shadow-map.resolution=256"]}]},
    {"name": "three", "title": "Third", "text": ["Words."], "formulas": ["x^2"], "pseudocode": "shadow-map", "marked": [2]}
  ]
})";

class DeckTest : public ::testing::Test {
protected:
    Deck written(const std::string& text) {
        folder_.write("d.json", text);
        return {(folder_.path() / "d.json").string(), kLoading};
    }
    static std::string with(std::string text, const std::string& what, const std::string& instead) {
        const std::size_t at = text.find(what);
        EXPECT_NE(at, std::string::npos) << what;
        return text.replace(at, what.size(), instead);
    }
    scene::TempFolder folder_;
};

TEST_F(DeckTest, EverySlideOfTheBuiltInDecksIsRead) {
    int slides = 0, pictures = 0, formulas = 0, drawings = 0;
    for (const std::string& name : builtInDecks(context::assetsRoot())) {
        Deck deck(name, kLoading);
        for (std::size_t i = 0; i < deck.slides().size(); ++i) {
            const Slide slide = deck.read(i);
            ++slides;
            EXPECT_FALSE(slide.title.empty());
            for (const SlidePicture& picture : slide.pictures) {
                ++pictures;
                drawings += !picture.figure.empty();
            }
            for (const std::string& tex : slide.formulas) {
                ++formulas;
                EXPECT_NO_THROW(drawing::Formula{tex}) << name << ", " << slide.name;
            }
        }
    }
    EXPECT_GE(slides, 50);
    EXPECT_GE(pictures, 80);
    EXPECT_GE(drawings, 7);
    EXPECT_GE(formulas, 15);
}

TEST_F(DeckTest, Utf16IsReadAsUtf8IsAndKeptAsUtf8) {
    std::string bytes = "\xfe\xff"; // the mark of the order in which a pair begins with its high byte
    for (const char c : std::string(kDeck))
        bytes += {'\0', c};
    const Deck deck = written(bytes);
    EXPECT_EQ(deck.slides(), written(kDeck).slides());
    EXPECT_EQ(deck.text(), kDeck); // what a slide is added to
}

TEST_F(DeckTest, LevelsAddUp) {
    Deck deck = written(kDeck);
    EXPECT_EQ(deck.slides(), (std::vector<std::string>{"one", "two", "three"}));
    const Slide one = deck.read(0), two = deck.read(1), three = deck.read(2);
    ASSERT_EQ(one.pictures.size(), 1u);
    EXPECT_EQ(one.pictures[0].state.slots[0].values(), (lab::Values{{"resolution", "512"}}));
    ASSERT_EQ(one.pictures[0].callouts.size(), 2u);
    EXPECT_FALSE(one.pictures[0].callouts[0].isArrow);
    EXPECT_TRUE(one.pictures[0].callouts[1].isArrow);
    ASSERT_EQ(two.pictures.size(), 2u);
    EXPECT_EQ(two.pictures[0].state.slots[0].values(), (lab::Values{{"resolution", "512"}}));
    EXPECT_EQ(two.pictures[1].state.slots[0].values(), (lab::Values{{"resolution", "256"}}));
    EXPECT_EQ(two.pictures[1].state.slots[0].stage.text(), "light-depth");
    EXPECT_TRUE(three.pictures.empty());
    EXPECT_EQ(three.marked, std::vector<int>{2});
}

TEST_F(DeckTest, AFaultOfOneSlideIsNoFaultOfTheOthers) {
    Deck deck = written(with(kDeck, R"("technique": "shadow-map")", R"("technique": "shadow-mop")"));
    EXPECT_THROW(deck.read(0), Error);
    EXPECT_EQ(deck.read(1).title, "Second");
}

TEST_F(DeckTest, EveryFaultIsToldWithItsPlace) {
    struct Case {
        const char *what, *instead, *place, *message;
    };
    const Case cases[] = {
        {R"("title": "T")", R"("titel": "T")", "d.json:2:3: ", "titel"},
        {R"("name": "two")", R"("name": "one")", "d.json:8:14: ", "two slides"},
        {R"("name": "two")", R"("name": "Two!")", "d.json:8:14: ", "small letters"},
        {R"("name": "two", )", "", "d.json:8:5: ", "needs a \"name\""},
        {R"("still-life")", R"("still-lif")", "d.json:2:26: ", "did you mean"},
        {R"("shadow-map"}], "pixel")", R"("shadow-mop"}], "pixel")", "d.json:5:", "shadow-map"},
        {R"("pixel": [0.5, 0.5])", R"("pixel": [0.5, 1.5])", "d.json:5:", "from 0 to 1"},
        {R"([0.1, 0.2, 0.3, 0.4])", R"([0.1, 0.2, 0.3, 0.9])", "d.json:6:27: ", "beyond the picture"},
        {R"("box": [0.1, 0.2, 0.3, 0.4])", R"("box": [0.1, 0.2, 0.3, 0.4], "to": [0, 0])", "d.json:6:", "write either"},
        {R"("alt": "A.")", R"("caption": "A.")", "d.json:5:5: ", "alt"},
        {R"("pixel": [0.5, 0.5])", R"("diagram": "pixel")", "d.json:5:", "about a pixel"},
        {R"("pixel": [0.5, 0.5])", R"("pixel": [0.5, 0.5], "diagram": "pixels")", "d.json:5:", R"(mean "pixel")"},
        {R"("marked": [2])", R"("marked": [99])", "d.json:10:", "no line"},
        {R"("marked": [2])", R"("marked": [1e300])", "d.json:10:", "no line"},
        {R"(, "text": ["Words."], "formulas": ["x^2"], "pseudocode": "shadow-map", "marked": [2])", "",
         "d.json:10:", "shows nothing"},
        {R"("pictures": [{"label": "left"}, )", R"("label": "x", "pictures": [{"label": "left"}, )",
         "d.json:9:", "belongs to one picture"},
    };
    int told = 0;
    for (const Case& one : cases) {
        try {
            Deck deck = written(with(kDeck, one.what, one.instead));
            for (std::size_t i = 0; i < deck.slides().size(); ++i)
                static_cast<void>(deck.read(i));
            ADD_FAILURE() << one.instead << " was taken";
        } catch (const Error& error) {
            const std::string message = error.what();
            EXPECT_EQ(error.status(), ExitStatus::badInput) << message;
            EXPECT_NE(message.find(one.place), std::string::npos) << message << "\nnot at " << one.place;
            EXPECT_NE(message.find(one.message), std::string::npos) << message << "\ndoes not say " << one.message;
            EXPECT_NE(message.find("; "), std::string::npos) << "no remedy: " << message;
            ++told;
        }
    }
    EXPECT_EQ(told, 16);
    EXPECT_THROW(Deck("shadws", kLoading), Error);
}

} // namespace
} // namespace shadowlab::course
