// Slides in the window, as they are taught: no title, legend or text of a built-in deck is cut or covered.
// SPDX-License-Identifier: MIT
#include "tests/window/screen_fixture.h"
#include "tests/window/shown_text.h"

namespace shadowlab {
namespace {

class SlideTextTest : public testing::ScreenFixture {
protected:
    /// Frames until the bands of headers and legends have their place. What is prepared for long, as radiosity is, need not be finished.
    static void show(testing::Lab& lab) {
        using Clock = std::chrono::steady_clock;
        constexpr int kAfter = 3;
        const auto isPreparing = [&] {
            return std::ranges::any_of(lab.screen.shownPanes(), [&](const window::ShownPane& shown) { return lab.ui.bench.pane(shown.pane).progress() < 1; });
        };
        const auto begin = Clock::now();
        for (int known = 0; known < kAfter && Clock::now() < begin + std::chrono::seconds(isPreparing() ? 2 : 60);) {
            lab.screen.frame(1.0 / 30);
            known = areLegendsKnown(lab) ? known + 1 : 0;
        }
    }
    /// Dots that formulas of the slide on show have: "1, 2, ..., n".
    static int dotsOf(const course::Slide& slide) {
        return static_cast<int>(std::ranges::count_if(slide.formulas, [](const std::string& tex) { return tex.find("\\ldots") != std::string::npos; }));
    }
    static bool areLegendsKnown(const testing::Lab& lab) {
        const lab::Document& document = lab.ui.bench.document();
        return std::ranges::all_of(lab.screen.shownPanes(), [&](const window::ShownPane& shown) {
            const lab::PaneState& state = document.panes[static_cast<std::size_t>(shown.pane)];
            if (document.layout == picture::Layout::diff || state.stage.isJudged())
                return lab.screen.errors().shownOn(document, shown.pane) != nullptr;
            const lab::Pane& pane = lab.ui.bench.pane(shown.pane);
            const lab::PaneState& asked = pane.drawnFor().state;
            return asked.stage == state.stage && asked.technique == state.technique && !pane.showsAnother();
        });
    }
    static void prepare(testing::Lab& lab, ivec2 size) {
        lab.ui.slides.loading = {.assetsRoot = context::assetsRoot(), .allowed = {}, .limits = {}};
        lab.ui.shown.presenter = true;
        lab.ui.shown.panel = false;
        lab.screen.setPatience(std::chrono::milliseconds(5));
        lab.screen.fit(size, 1);
    }
    static void expectWholeText(const testing::Lab& lab, const std::string& where) {
        const std::vector<testing::ShownLetter> letters = testing::shownLetters();
        EXPECT_GT(letters.size(), 20u) << where;
        EXPECT_EQ(textOf(cutLetters(letters, dotsOf(lab.ui.slides.slide))), "") << where;
        EXPECT_EQ(textOf(coveredLetters(letters)), "") << where << ": one text lies over another";
        EXPECT_TRUE(testing::hasRoom("story")) << where << ": the text in the band scrolls";
        EXPECT_TRUE(lab.ui.messages.empty()) << where;
    }
    /// Through a deck, picture by picture. `outside`: each of them seen from outside.
    static int goThrough(const std::string& deck, ivec2 size, bool outside) {
        testing::Lab lab(scene("sphere-on-plane"), size);
        prepare(lab, size);
        int pictures = 0;
        for (window::openDeck(lab.ui, deck); lab.ui.requests.news.empty(); window::stepSlides(lab.ui, 1), ++pictures) {
            if (outside) window::chooseStage(lab.ui, {.id = "outside", .light = {}});
            show(lab);
            expectWholeText(lab, deck + ", slide " + std::to_string(lab.ui.slides.at + 1) + " " + lab.ui.slides.slide.name + ", picture " +
                                     std::to_string(lab.ui.slides.stop + 1) + (outside ? ", from outside" : ""));
        }
        return pictures;
    }
};

constexpr ivec2 kSmallHall{1280, 720}, kLargeHall{1920, 1080};

TEST_F(SlideTextTest, NoneIsCutInALectureHall) {
    for (const ivec2 size : {kSmallHall, kLargeHall}) {
        EXPECT_GE(goThrough("shadows", size, false), 28) << size.x;
        EXPECT_GE(goThrough("shadow-rendering-techniques", size, false), 71) << size.x;
    }
}

TEST_F(SlideTextTest, NoneIsCutFromOutside) { EXPECT_GE(goThrough("shadows", kSmallHall, true), 28); }

// The longest text of all: a step of the lecture's algorithm, with its lines of source at the side. The picture is what it is about.
TEST_F(SlideTextTest, AStepBesideItsSourceHasALargePicture) {
    testing::Lab lab(scene("sphere-on-plane"), kSmallHall);
    prepare(lab, kSmallHall);
    window::openDeck(lab.ui, "shadows", "algorithm");
    for (int i = 0; i < 3; ++i) {
        window::goThroughSteps(lab.ui, 1);
        show(lab); // the next step is known when this one is drawn
    }
    lab.ui.shown.source = true;
    show(lab);
    ASSERT_EQ(window::storyMode(lab.ui), window::StoryMode::steps);
    EXPECT_GE(lab.screen.shownPanes().front().area.size.y, 0.4 * kSmallHall.y);
    EXPECT_TRUE(testing::hasRoom("story"));
}

} // namespace
} // namespace shadowlab
