// The window's picture without a window: keys, layouts, sizes and faults, and never a GL object lost.
// SPDX-License-Identifier: MIT
#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <set>
#include <tuple>

#include "app/window/actions.h"
#include "tests/window/screen_fixture.h"

namespace shadowlab {
namespace {

using testing::Lab;

class ScreenTest : public testing::ScreenFixture {};

TEST_F(ScreenTest, EveryLayoutAndPartDrawsSomethingElseAndNothingFails) {
    Lab lab(scene("three-lights"), {640, 400});
    settle(lab.screen);
    std::vector<std::vector<std::uint8_t>> seen{pixels(lab.screen)};
    const auto expectNew = [&](const char* what) {
        settle(lab.screen);
        const std::vector<std::uint8_t> now = pixels(lab.screen);
        EXPECT_EQ(std::ranges::find(seen, now), seen.end()) << what;
        seen.push_back(now);
        for (int i = 0; i < lab::kPanes; ++i)
            EXPECT_EQ(lab.ui.bench.pane(i).failure(), "") << what;
        EXPECT_TRUE(lab.screen.messages().empty()) << what;
    };
    lab.ui.shown.panel = false;
    expectNew("without settings");
    for (const picture::Layout layout : {picture::Layout::single, picture::Layout::side, picture::Layout::grid,
                                         picture::Layout::diff, picture::Layout::split}) {
        chooseLayout(lab.ui, layout);
        if (layout == picture::Layout::split) lab.ui.shown.strip = true;
        expectNew("layout");
    }
    lab.ui.shown.strip = false;
    for (const char* stage :
         {"error", "truth", "scanline", "shadow-outline", "outside", "mesh-edges", "visibility", "pass:light"}) {
        chooseStage(lab.ui, picture::StageRef::parse(stage));
        expectNew(stage);
    }
    chooseStage(lab.ui, {});
    lab.ui.shown.magnifier = true;
    expectNew("magnifier");
    lab.ui.shown.magnifier = false;
    lab.ui.shown.keys = true;
    expectNew("keys");
    lab.ui.shown.keys = false;
    togglePresenter(lab.ui);
    lab.screen.fit({640, 400}, 1);
    expectNew("presenter");
    EXPECT_GE(seen.size(), 15u);
}

/// Of the pixels of a pane, upper rows first, the share that has the colour of the pane's own picture.
double shareAsInPicture(const window::Screen& screen, const window::ShownPane& shown, const lab::Pane& pane) {
    const image::Image window = picture::PictureEncoder::read(screen.picture());
    const image::Image own = picture::PictureEncoder::read(pane.picture().texture);
    const ivec2 corner(static_cast<int>(shown.pictureCorner.x), static_cast<int>(shown.pictureCorner.y));
    int same = 0, all = 0;
    for (int y = shown.area.corner.y; y < shown.area.corner.y + shown.area.size.y; ++y)
        for (int x = shown.area.corner.x; x < shown.area.corner.x + shown.area.size.x; ++x, ++all)
            same += window.at(x, y) == own.at(x - corner.x, y - corner.y);
    EXPECT_GT(all, 40000);
    return static_cast<double>(same) / all;
}

TEST_F(ScreenTest, PicturesStandOnTheScreenPixelByPixelAsTheyWereDrawn) {
    Lab lab(scene("leafy"), {640, 400}); // leaves: a picture moved by one pixel is another one nearly everywhere
    lab.ui.shown.handles = lab.ui.shown.panel = false;
    for (const picture::Layout layout : {picture::Layout::single, picture::Layout::split, picture::Layout::side}) {
        chooseLayout(lab.ui, layout);
        settle(lab.screen);
        ASSERT_FALSE(lab.screen.shownPanes().empty());
        // The rest lies under the split line with its knob, and under lines between panes.
        for (const window::ShownPane& shown : lab.screen.shownPanes())
            EXPECT_GT(shareAsInPicture(lab.screen, shown, lab.ui.bench.pane(shown.pane)), 0.96) << static_cast<int>(layout);
    }
}

TEST_F(ScreenTest, SizesFromNothingToLargeKeepEveryObject) {
    Lab lab(scene("sphere-on-plane"), {320, 200});
    settle(lab.screen);
    const int before = gl::liveObjects;
    const std::vector<std::uint8_t> picture = pixels(lab.screen);
    int drawn = 0;
    for (const ivec2 size : {ivec2(0, 0), ivec2(1, 1), ivec2(3, 200), ivec2(640, 2), ivec2(80, 60), ivec2(1024, 768),
                             ivec2(2000, 40), ivec2(0, 300), ivec2(320, 200)}) {
        lab.screen.fit(size, 1);
        drawn += lab.screen.frame(0.03) ? 1 : 0;
        lab.screen.frame(0.03);
        gl::check("resize");
    }
    EXPECT_EQ(drawn, 7) << "all but those of no size";
    // To a screen of other density and back, as a window does that is dragged from one to the other.
    for (const float scale : {2.0f, 1.5f, 0.75f, 3.0f, 1.0f}) {
        lab.screen.fit({320, 200}, scale);
        EXPECT_TRUE(lab.screen.frame(0.03));
        gl::check("another density");
    }
    // Larger than any texture: as much as there can be is drawn.
    GLint most = 0;
    glGetIntegerv(GL_MAX_TEXTURE_SIZE, &most);
    lab.screen.fit({most + 100, 40}, 1);
    EXPECT_TRUE(lab.screen.frame(0.03));
    EXPECT_EQ(lab.screen.framebuffer().size(), ivec2(most, 40));
    lab.screen.fit({320, 200}, 1);
    settle(lab.screen);
    EXPECT_EQ(gl::liveObjects, before);
    EXPECT_EQ(pixels(lab.screen).size(), picture.size());
}

TEST_F(ScreenTest, EveryKeyHasOneMeaningAndRunsWithoutAFault) {
    std::set<std::tuple<int, bool, bool>> keys;
    std::set<std::string> ids;
    for (const window::Action& action : window::actions()) {
        EXPECT_TRUE(keys.insert({action.key, action.ctrl, action.shift}).second) << action.keys << " has two meanings";
        EXPECT_TRUE(ids.insert(action.id).second) << action.id;
    }
    EXPECT_GE(keys.size(), 55u);
    Lab lab(scene("sphere-on-plane"), {400, 260});
    settle(lab.screen);
    for (const window::Action& action : window::actions()) {
        lab.ui.keys.push_back({action.key, action.ctrl, action.shift, false, false});
        lab.screen.frame(0.03);
        const std::vector<std::string>& ran = lab.screen.ran();
        EXPECT_NE(std::ranges::find(ran, action.id), ran.end()) << action.keys << " did nothing";
        lab.ui.panelHasKeys = false;
    }
    lab.ui.bench.play(false);
    EXPECT_TRUE(lab.ui.requests.quit && lab.ui.requests.screenshot && lab.ui.requests.saveScene);
}

// In the window's own type, which is read from the last row, it needs pages.
TEST_F(ScreenTest, TheListOfKeysIsTurnedAndClosedByOneKey) {
    for (const ivec2 size : {ivec2(1280, 720), ivec2(1920, 1080)}) {
        Lab lab(scene("still-life"), size);
        togglePresenter(lab.ui);
        lab.screen.fit(size, 1);
        const auto pressH = [&] {
            lab.ui.keys.push_back({GLFW_KEY_H, false, false, false, false});
            lab.screen.frame(0.03);
        };
        pressH();
        EXPECT_GT(lab.ui.keyPages, 1);
        const int pages = lab.ui.keyPages;
        std::set<std::vector<std::uint8_t>> seen;
        for (int page = 0; page < pages; ++page) {
            EXPECT_TRUE(lab.ui.shown.keys);
            EXPECT_EQ(lab.ui.keyPage, page);
            EXPECT_TRUE(seen.insert(pixels(lab.screen)).second) << "page " << page;
            pressH();
        }
        EXPECT_FALSE(lab.ui.shown.keys);
        pressH();
        pressH();
        EXPECT_EQ(lab.ui.keyPage, 1);
        lab.ui.keys.push_back({GLFW_KEY_ESCAPE, false, false, false, false});
        lab.screen.frame(0.03);
        pressH();
        EXPECT_EQ(lab.ui.keyPage, 0) << "it opens at its beginning";
    }
}

// An open list that the arrows went through is closed by ImGui itself, before the key comes to the window.
TEST_F(ScreenTest, EscAfterAListThatHasClosedByItselfDoesNothingElse) {
    Lab lab(scene("still-life"), {640, 400});
    lab.screen.frame(0.03);
    lab.ui.hadPopup = true;
    lab.ui.shown.magnifier = true;
    lab.ui.keys.push_back({GLFW_KEY_ESCAPE, false, false, false, false});
    lab.screen.frame(0.03);
    EXPECT_EQ(lab.screen.ran(), std::vector<std::string>{"leave-popup"});
    EXPECT_TRUE(lab.ui.shown.magnifier) << "one thing at a time";
}

TEST_F(ScreenTest, AWrongSettingLeavesTheLastPictureAndSaysWhy) {
    Lab lab(scene("sphere-on-plane"), {400, 260});
    settle(lab.screen);
    const GLuint picture = lab.ui.bench.pane(0).picture().texture.id();
    lab.ui.bench.change("", [](lab::Document& d) { d.panes[0].settings["shadow-map"]["resolution"] = "7"; });
    lab.screen.frame(0.03);
    EXPECT_NE(lab.ui.bench.pane(0).failure().find("64..32768"), std::string::npos)
        << lab.ui.bench.pane(0).failure();
    EXPECT_EQ(lab.ui.bench.pane(0).picture().texture.id(), picture);
    lab.ui.bench.undo();
    settle(lab.screen);
    EXPECT_EQ(lab.ui.bench.pane(0).failure(), "");
}

} // namespace
} // namespace shadowlab
