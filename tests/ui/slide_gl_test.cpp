// Slides in the window: every picture of every built-in deck, forward and back; what the window shows is what the slide has;
// and what is seen becomes a slide with one key.
// SPDX-License-Identifier: MIT
#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include "app/session/assets.h"
#include "app/session/state_picture.h"
#include "app/ui/screen.h"
#include "tests/foundation/scene/scene_files.h"
#include "tests/support/gl_fixture.h"

namespace shadowlab {
namespace {

class SlideDeskTest : public testing::GlTest {
protected:
    static scene::LoadOptions loading() { return {.assetsRoot = session::assetsRoot(), .allowed = {}, .limits = {}}; }
    static session::Document beginning() {
        return session::newDocument(scene::loadScene("sphere-on-plane", loading()), "sphere-on-plane");
    }
    struct Lab {
        Lab() : desk(beginning()) {
            desk.slides.decks = session::builtInDecks(session::assetsRoot());
            desk.slides.loading = loading();
            desk.lesson.loading = loading();
        }
        void press(int key, bool shift = false) {
            desk.keys.push_back({key, false, shift, false, false});
            screen.frame(0.03);
        }
        ui::Desk desk;
        ui::Screen screen{desk, session::assetsRoot() / "fonts" / "DejaVuSans.ttf"};
    };
};

TEST_F(SlideDeskTest, EveryDeckGoesToItsEndAndBack) {
    Lab lab;
    ui::Desk& desk = lab.desk;
    const session::Document before = desk.bench.document();
    int pictures = 0;
    for (const std::string& name : desk.slides.decks) {
        ui::openDeck(desk, name);
        std::vector<std::pair<std::string, std::size_t>> way;
        do {
            ASSERT_LT(way.size(), 500u);
            ASSERT_TRUE(desk.messages.empty()) << desk.messages.front().text;
            way.emplace_back(desk.slides.slide.name, desk.slides.stop);
            if (!desk.slides.stops.empty()) {
                ++pictures;
                EXPECT_EQ(desk.bench.document(), desk.slides.stops[desk.slides.stop].document);
            }
            ui::stepSlides(desk, 1);
        } while (desk.requests.news.empty());
        desk.requests.news.clear();
        EXPECT_EQ(way.back().first, desk.slides.deck->slides().back());
        for (auto stop = way.rbegin() + 1; stop != way.rend(); ++stop) {
            ui::stepSlides(desk, -1);
            EXPECT_EQ(std::pair(desk.slides.slide.name, desk.slides.stop), *stop);
        }
    }
    EXPECT_GE(pictures, 56) << "slides of both lectures";
    ui::leaveSlides(desk);
    EXPECT_EQ(desk.bench.document(), before);
}

TEST_F(SlideDeskTest, KeysGoOnAndBackAndOut) {
    Lab lab;
    lab.screen.fit({640, 400}, 1);
    const session::Document before = lab.desk.bench.document();
    ui::openDeck(lab.desk, "shadows", "from-the-light");
    ASSERT_EQ(lab.desk.slides.stops.size(), 3u);
    lab.press(GLFW_KEY_S);
    EXPECT_EQ(lab.desk.slides.stop, 1u);
    EXPECT_EQ(lab.desk.bench.document().panes[0].stage, "light-view");
    lab.press(GLFW_KEY_S, true);
    lab.press(GLFW_KEY_S, true);
    EXPECT_EQ(lab.desk.slides.slide.name, "algorithm");
    ui::openLesson(lab.desk, "acne");
    EXPECT_FALSE(lab.desk.slides.isOn()) << "a lesson takes the place of slides";
    ui::openDeck(lab.desk, "shadows");
    EXPECT_FALSE(lab.desk.lesson.isOn()) << "and the other way round";
    lab.press(GLFW_KEY_ESCAPE);
    EXPECT_FALSE(lab.desk.slides.isOn());
    EXPECT_EQ(lab.desk.bench.document(), before);
}

TEST_F(SlideDeskTest, WhatIsNotThereIsSaidAndNothingChanges) {
    Lab lab;
    const session::Document before = lab.desk.bench.document();
    ui::openDeck(lab.desk, "shadows", "silhouetes");
    ASSERT_EQ(lab.desk.messages.size(), 1u);
    EXPECT_NE(lab.desk.messages[0].text.find("silhouettes"), std::string::npos);
    EXPECT_FALSE(lab.desk.slides.isOn());
    EXPECT_EQ(lab.desk.bench.document(), before);
}

// The pane's picture and the slide's are made by different code (Workbench, StatePicture): they agree in every byte.
// Stages with a legend are left to the eye; it stands in the slide's picture and beside the window's.
TEST_F(SlideDeskTest, TheWindowShowsWhatTheSlideHas) {
    constexpr ivec2 kSize{320, 180};
    const image::Font font(session::assetsRoot() / "fonts" / "DejaVuSans.ttf");
    Lab lab;
    int compared = 0;
    session::Deck deck("shadow-rendering-techniques", loading());
    for (std::size_t i = 0; i < deck.slides().size() && compared < 6; ++i) {
        const session::Slide slide = deck.read(i);
        for (const session::SlidePicture& picture : slide.pictures) {
            const session::ShownState& state = picture.state;
            if (state.slots.size() != 1 || !state.slots[0].stage.empty() || !picture.figure.empty() ||
                state.slots[0].technique == "ray-traced" || state.slots[0].technique == "radiosity")
                continue;
            lab.desk.bench.showDocument(session::documentOf(state));
            lab.desk.bench.update(kSize, Deadline::max());
            const image::Image window = session::PictureEncoder::read(lab.desk.bench.pane(0).picture().texture);
            EXPECT_EQ(window.rgba, session::drawState(state, {.size = kSize}, font).rgba) << slide.name;
            ++compared;
        }
    }
    EXPECT_GE(compared, 3);
}

TEST_F(SlideDeskTest, OneKeyMakesASlideOfWhatIsSeen) {
    const scene::TempFolder folder;
    const std::filesystem::path home = std::filesystem::current_path();
    std::filesystem::current_path(folder.path());
    Lab lab;
    lab.screen.fit({640, 400}, 1);
    lab.press(GLFW_KEY_E);
    lab.press(GLFW_KEY_W);
    EXPECT_TRUE(lab.desk.requests.saveSlide);
    ui::saveAsSlide(lab.desk); // as the window does when it is asked to
    ui::saveAsSlide(lab.desk);
    std::filesystem::current_path(home);
    session::Deck deck((folder.path() / "slides.json").string(), loading());
    ASSERT_EQ(deck.slides().size(), 2u);
    const std::vector<session::SlideStop> stops = session::stopsOf(deck.read(1));
    ASSERT_EQ(stops.size(), 1u);
    EXPECT_EQ(stops[0].document.panes[0].stage, "error");
    EXPECT_EQ(stops[0].document.layout, session::Layout::split);
}

// Somebody may write the deck anew while it is shown: there is no slide any more where the window was.
TEST_F(SlideDeskTest, ADeckMayBecomeShorter) {
    const scene::TempFolder folder;
    const std::filesystem::path home = std::filesystem::current_path();
    std::filesystem::current_path(folder.path());
    Lab lab;
    lab.screen.fit({640, 400}, 1);
    ui::saveAsSlide(lab.desk);
    const std::filesystem::path file = folder.path() / "slides.json";
    const std::filesystem::path shorter = folder.path() / "shorter.json";
    std::filesystem::copy_file(file, shorter);
    for (int i = 0; i < 4; ++i)
        ui::saveAsSlide(lab.desk);
    ui::openDeck(lab.desk, file.string());
    while (lab.desk.slides.at < 4)
        ui::stepSlides(lab.desk, 1);
    std::filesystem::rename(shorter, file);
    ui::saveAsSlide(lab.desk);
    ASSERT_TRUE(lab.desk.slides.deck);
    ASSERT_EQ(lab.desk.slides.deck->slides().size(), 2u);
    EXPECT_EQ(lab.desk.slides.at, 1u);
    ui::stepSlides(lab.desk, -1);
    EXPECT_EQ(lab.desk.slides.at, 0u);
    EXPECT_TRUE(lab.screen.messages().empty());
    std::filesystem::current_path(home);
}

} // namespace
} // namespace shadowlab
