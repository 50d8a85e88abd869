// Slides in the window: every picture of every built-in deck, forward and back; what the window shows is what the slide has;
// and what is seen becomes a slide with one key.
// SPDX-License-Identifier: MIT
#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include "app/context/assets.h"
#include "app/course/lessons/lesson.h"
#include "app/course/state_picture.h"
#include "app/window/panels/story_page.h"
#include "app/window/screen.h"
#include "tests/foundation/scene/scene_files.h"
#include "tests/support/gl_fixture.h"
#include "tests/support/levels_apart.h"

namespace shadowlab {
namespace {

class SlideStateTest : public testing::GlTest {
protected:
    static scene::LoadOptions loading() { return {.assetsRoot = context::assetsRoot(), .allowed = {}, .limits = {}}; }
    static lab::Document beginning() {
        return lab::newDocument(scene::loadScene("sphere-on-plane", loading()), "sphere-on-plane");
    }
    struct Lab {
        Lab() : ui(beginning()) {
            ui.slides.decks = course::builtInDecks(context::assetsRoot());
            ui.slides.loading = loading();
            ui.lesson.loading = loading();
        }
        void press(int key, bool shift = false) {
            ui.keys.push_back({key, false, shift, false, false});
            screen.frame(0.03);
        }
        window::WindowState ui;
        window::Screen screen{ui, context::assetsRoot() / "fonts" / "DejaVuSans.ttf"};
    };
};

TEST_F(SlideStateTest, EveryDeckGoesToItsEndAndBack) {
    Lab lab;
    window::WindowState& ui = lab.ui;
    const lab::Document before = ui.bench.document();
    int pictures = 0;
    for (const std::string& name : ui.slides.decks) {
        window::openDeck(ui, name);
        std::vector<std::pair<std::string, std::size_t>> way;
        do {
            ASSERT_LT(way.size(), 500u);
            ASSERT_TRUE(ui.messages.empty()) << ui.messages.front().text;
            way.emplace_back(ui.slides.slide.name, ui.slides.stop);
            if (!ui.slides.stops.empty()) {
                ++pictures;
                EXPECT_EQ(ui.bench.document(), ui.slides.stops[ui.slides.stop].document);
            }
            window::stepSlides(ui, 1);
        } while (ui.requests.news.empty());
        ui.requests.news.clear();
        EXPECT_EQ(way.back().first, ui.slides.deck->slides().back());
        for (auto stop = way.rbegin() + 1; stop != way.rend(); ++stop) {
            window::stepSlides(ui, -1);
            EXPECT_EQ(std::pair(ui.slides.slide.name, ui.slides.stop), *stop);
        }
    }
    EXPECT_GE(pictures, 56) << "slides of both lectures";
    window::leaveSlides(ui);
    EXPECT_EQ(ui.bench.document(), before);
}

TEST_F(SlideStateTest, KeysGoOnAndBackAndOut) {
    Lab lab;
    lab.screen.fit({640, 400}, 1);
    const lab::Document before = lab.ui.bench.document();
    window::openDeck(lab.ui, "shadows", "from-the-light");
    ASSERT_EQ(lab.ui.slides.stops.size(), 3u);
    lab.press(GLFW_KEY_S);
    EXPECT_EQ(lab.ui.slides.stop, 1u);
    EXPECT_EQ(lab.ui.bench.document().panes[0].stage.text(), "light-view");
    lab.press(GLFW_KEY_S, true);
    lab.press(GLFW_KEY_S, true);
    EXPECT_EQ(lab.ui.slides.slide.name, "algorithm");
    window::openLesson(lab.ui, "acne");
    EXPECT_FALSE(lab.ui.slides.isOn()) << "a lesson takes the place of slides";
    window::openDeck(lab.ui, "shadows");
    EXPECT_FALSE(lab.ui.lesson.isOn()) << "and the other way round";
    lab.press(GLFW_KEY_ESCAPE);
    EXPECT_FALSE(lab.ui.slides.isOn());
    EXPECT_EQ(lab.ui.bench.document(), before);
}

// Words of a slide in the band have their formulas set as on the slide; those without have no need of it.
TEST_F(SlideStateTest, TheBandHasFormulasWhereTheSlideHas) {
    Lab lab;
    lab.screen.fit({960, 600}, 1);
    int formulas = 0, plain = 0;
    for (const char* slide : {"lambert", "facing", "shadow-volume", "solving"}) {
        window::openDeck(lab.ui, "shadow-rendering-techniques", slide);
        for (const window::StoryLine& line : window::slidePage(lab.ui).lines) {
            EXPECT_EQ(line.text.find('$'), std::string::npos) << "plain words have none";
            EXPECT_EQ(line.written.empty(), line.written.find('$') == std::string::npos) << line.text;
            ++(line.written.empty() ? plain : formulas);
        }
    }
    EXPECT_GE(formulas, 4 + 6 + 2) << "of the text, displayed, and of label and caption";
    EXPECT_GE(plain, 2);
}

// A presenter's remote goes from slide to slide; a drawing stands beside the picture that its pixel is marked in.
TEST_F(SlideStateTest, PageKeysTurnSlidesAndDrawingsAreShown) {
    Lab lab;
    lab.ui.live = false;
    lab.screen.setPatience(std::chrono::hours(1));
    lab.screen.fit({960, 600}, 1);
    lab.screen.frame(0.03);
    const ivec2 whole = lab.screen.pictureSize();
    window::openDeck(lab.ui, "shadows", "one-pixel");
    ASSERT_EQ(window::slideFigureKind(lab.ui), window::SlideFigureKind::ofPixel);
    for (int i = 0; i < 200 && !lab.screen.figure().texture(); ++i)
        lab.screen.frame(0.03);
    ASSERT_TRUE(lab.screen.figure().texture()) << lab.screen.figure().fault();
    const ivec2 drawing = lab.screen.figure().texture().size(), picture = lab.screen.pictureSize();
    EXPECT_GT(drawing.x, whole.x / 3);
    EXPECT_LE(drawing.x + picture.x, whole.x) << "beside each other";
    // A pixel of the slide is the same place in a picture of the same shape; one pixel of rounding.
    EXPECT_NEAR(picture.x / course::kLessonAspect, picture.y, 1);
    const std::string first = lab.ui.slides.slide.name;
    lab.press(GLFW_KEY_PAGE_DOWN);
    EXPECT_NE(lab.ui.slides.slide.name, first);
    lab.press(GLFW_KEY_PAGE_UP);
    EXPECT_EQ(lab.ui.slides.slide.name, first);
    lab.press(GLFW_KEY_ESCAPE);
    EXPECT_FALSE(lab.ui.slides.isOn());
    EXPECT_EQ(lab.screen.figure().texture().size(), ivec2(0));
}

TEST_F(SlideStateTest, EscClosesOneThingAtATimeAndSLeadsBackToTheSlide) {
    Lab lab;
    lab.screen.fit({640, 400}, 1);
    window::WindowState& ui = lab.ui;
    window::openDeck(ui, "shadow-rendering-techniques", "extrusion");
    ASSERT_FALSE(ui.slides.stops.empty());
    const picture::StageRef told = ui.slides.stops.front().document.panes[0].stage;
    lab.press(GLFW_KEY_O);
    ui.shown.strip = ui.shown.magnifier = true;
    ASSERT_TRUE(ui.bench.activeState().stage.isOutside() != told.isOutside());
    lab.press(GLFW_KEY_ESCAPE);
    EXPECT_FALSE(ui.shown.strip || ui.shown.magnifier) << "first what lies beside the pictures";
    EXPECT_NE(ui.bench.activeState().stage, told);
    lab.press(GLFW_KEY_ESCAPE);
    EXPECT_EQ(ui.bench.activeState().stage, told) << "then what was chosen by hand";
    ASSERT_TRUE(ui.slides.isOn());
    lab.press(GLFW_KEY_ESCAPE);
    EXPECT_FALSE(ui.slides.isOn());
    lab.press(GLFW_KEY_S);
    ASSERT_TRUE(ui.slides.isOn());
    EXPECT_EQ(ui.slides.deck->name(), "shadow-rendering-techniques") << "not the first deck there is";
    EXPECT_EQ(ui.slides.slide.name, "extrusion");
}

// Four pictures, the text and all stages do not fit: the text makes room, and comes back.
TEST_F(SlideStateTest, TheStripOfStagesLeavesASlidesPicturesTheirRoom) {
    Lab lab;
    lab.ui.shown.presenter = true;
    lab.screen.fit({1280, 720}, 1);
    openDeck(lab.ui, "shadows", "from-the-eye");
    const auto height = [&] {
        for (int i = 0; i < 3; ++i) // the legends take their lines when the pictures are known
            lab.screen.frame(0.03);
        return lab.screen.shownPanes().front().area.size.y;
    };
    const int without = height();
    lab.press(GLFW_KEY_T);
    EXPECT_GE(height(), 120) << "in a window of 720 lines";
    lab.press(GLFW_KEY_T);
    EXPECT_EQ(height(), without);
}

TEST_F(SlideStateTest, WhatIsNotThereIsSaidAndNothingChanges) {
    Lab lab;
    const lab::Document before = lab.ui.bench.document();
    window::openDeck(lab.ui, "shadows", "silhouetes");
    ASSERT_EQ(lab.ui.messages.size(), 1u);
    EXPECT_NE(lab.ui.messages[0].text.find("silhouettes"), std::string::npos);
    EXPECT_FALSE(lab.ui.slides.isOn());
    EXPECT_EQ(lab.ui.bench.document(), before);
}

// The pane's picture and the slide's are made by different code (Workbench, StatePicture). They agree, up to the one level by which
// finished pixels, which the window draws, may differ from radiance that is encoded (techniques/shading_passes.h).
// Stages with a legend are left to the eye; it stands in the slide's picture and beside the window's.
TEST_F(SlideStateTest, TheWindowShowsWhatTheSlideHas) {
    constexpr ivec2 kSize{320, 180};
    const image::Font font(context::assetsRoot() / "fonts" / "DejaVuSans.ttf");
    Lab lab;
    int compared = 0;
    course::Deck deck("shadow-rendering-techniques", loading());
    for (std::size_t i = 0; i < deck.slides().size() && compared < 6; ++i) {
        const course::Slide slide = deck.read(i);
        for (const course::SlidePicture& picture : slide.pictures) {
            const course::ShownState& state = picture.state;
            if (state.slots.size() != 1 || !state.slots[0].stage.isPicture() || !picture.figure.empty() ||
                state.slots[0].technique == "ray-traced" || state.slots[0].technique == "radiosity")
                continue;
            lab.ui.bench.showDocument(course::documentOf(state));
            lab.ui.bench.update(kSize, Deadline::max());
            const image::Image window = picture::PictureEncoder::read(lab.ui.bench.pane(0).picture().texture);
            const image::Image drawn = course::drawState(state, {.size = kSize}, font);
            ASSERT_EQ(ivec2(window.width, window.height), ivec2(drawn.width, drawn.height));
            EXPECT_EQ(testing::differingPixels(window, drawn, 1), 0) << slide.name;
            ++compared;
        }
    }
    EXPECT_GE(compared, 3);
}

TEST_F(SlideStateTest, OneKeyMakesASlideOfWhatIsSeen) {
    const scene::TempFolder folder;
    const std::filesystem::path home = std::filesystem::current_path();
    std::filesystem::current_path(folder.path());
    Lab lab;
    lab.screen.fit({640, 400}, 1);
    lab.press(GLFW_KEY_E);
    lab.press(GLFW_KEY_W);
    EXPECT_TRUE(lab.ui.requests.saveSlide);
    window::saveAsSlide(lab.ui); // as the window does when it is asked to
    window::saveAsSlide(lab.ui);
    std::filesystem::current_path(home);
    course::Deck deck((folder.path() / "slides.json").string(), loading());
    ASSERT_EQ(deck.slides().size(), 2u);
    const std::vector<course::SlideStop> stops = course::stopsOf(deck.read(1));
    ASSERT_EQ(stops.size(), 1u);
    EXPECT_EQ(stops[0].document.panes[0].stage.text(), "error");
    EXPECT_EQ(stops[0].document.layout, picture::Layout::split);
}

// Somebody may write the deck anew while it is shown: there is no slide any more where the window was.
TEST_F(SlideStateTest, ADeckMayBecomeShorter) {
    const scene::TempFolder folder;
    const std::filesystem::path home = std::filesystem::current_path();
    std::filesystem::current_path(folder.path());
    Lab lab;
    lab.screen.fit({640, 400}, 1);
    window::saveAsSlide(lab.ui);
    const std::filesystem::path file = folder.path() / "slides.json";
    const std::filesystem::path shorter = folder.path() / "shorter.json";
    std::filesystem::copy_file(file, shorter);
    for (int i = 0; i < 4; ++i)
        window::saveAsSlide(lab.ui);
    window::openDeck(lab.ui, file.string());
    while (lab.ui.slides.at < 4)
        window::stepSlides(lab.ui, 1);
    std::filesystem::rename(shorter, file);
    window::saveAsSlide(lab.ui);
    ASSERT_TRUE(lab.ui.slides.deck);
    ASSERT_EQ(lab.ui.slides.deck->slides().size(), 2u);
    EXPECT_EQ(lab.ui.slides.at, 1u);
    window::stepSlides(lab.ui, -1);
    EXPECT_EQ(lab.ui.slides.at, 0u);
    EXPECT_TRUE(lab.screen.messages().empty());
    std::filesystem::current_path(home);
}

} // namespace
} // namespace shadowlab
