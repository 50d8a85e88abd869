// The window's picture without a window: keys, layouts, sizes and faults, and never a GL object lost.
// SPDX-License-Identifier: MIT
#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <cmath>
#include <optional>
#include <set>
#include <thread>
#include <tuple>

#include "app/context/assets.h"
#include "app/picture/judged_slot.h"
#include "app/window/actions.h"
#include "app/window/panels/panels.h"
#include "app/window/screen.h"
#include "techniques/foundation/base/look.h"
#include "techniques/foundation/scene/load/load.h"
#include "tests/support/gl_fixture.h"

namespace shadowlab {
namespace {

using window::WindowState;
using window::Screen;

class ScreenTest : public testing::GlTest {
protected:
    static scene::Snapshot scene(const std::string& name) {
        return scene::loadScene(name, {.assetsRoot = context::assetsRoot(), .allowed = {}, .limits = {}});
    }
    static void settle(Screen& screen) {
        for (int settled = 0, frames = 0; settled < 3 && frames < 4000; ++frames) {
            screen.frame(1.0 / 30);
            settled = screen.isSettled() ? settled + 1 : 0;
            if (settled == 0) std::this_thread::sleep_for(std::chrono::milliseconds(2));
        }
        EXPECT_TRUE(screen.isSettled());
    }
    static std::vector<std::uint8_t> pixels(const Screen& screen) {
        return picture::PictureEncoder::read(screen.picture()).rgba;
    }
};

/// The state of a window and its screen, without a user (`live` is false): exact errors come at once.
struct Lab {
    Lab(const scene::Snapshot& scene, ivec2 size)
        : ui(lab::newDocument(scene, scene->name)), screen(calm(ui), font()) {
        screen.setPatience(std::chrono::hours(1));
        screen.fit(size, 1);
    }
    static std::filesystem::path font() { return context::assetsRoot() / "fonts" / "DejaVuSans.ttf"; }
    static WindowState& calm(WindowState& ui) {
        ui.live = false;
        ui.bench.allowDraft(false);
        return ui;
    }
    WindowState ui;
    Screen screen;
};

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

TEST_F(ScreenTest, LiveErrorsAreThoseOfTheTechniques) {
    Lab lab(scene("eye-in-shadow"), {640, 400});
    lab.ui.bench.change("", [](lab::Document& d) {
        d.panes[0].technique = "shadow-volume-zpass";
        d.layout = picture::Layout::side;
    });
    settle(lab.screen);
    const lab::PaneErrors *zpass = lab.screen.errors().errors(0), *zfail = lab.screen.errors().errors(1);
    ASSERT_TRUE(zpass && zfail);
    EXPECT_TRUE(zpass->exact && zfail->exact);
    EXPECT_GT(zpass->counts.wrong(), 1000) << "the eye stands in a shadow: the textbook algorithm fails";
    EXPECT_LE(zfail->counts.wrong(), 1) << "and depth fail holds, but for a crack";
    EXPECT_GT(zfail->counts.lit, 5000);
    EXPECT_GT(zfail->counts.shadowed, 5000);
}

/// Pixels that a pane is wrong in, with errors that are many enough to tell halves of the picture from the whole.
int wrongOf(const Lab& lab, int pane) {
    const lab::PaneErrors* const known = lab.screen.errors().errors(pane);
    EXPECT_TRUE(known && known->exact);
    return known ? known->counts.wrong() : -1;
}

/// A coarse map beside volumes.
lab::Document coarseMap(lab::Document document) {
    document.panes[0].settings["shadow-map"]["resolution"] = "256";
    document.panes[0].technique = "shadow-map";
    document.panes[1].technique = "shadow-volume-zfail";
    return document;
}

TEST_F(ScreenTest, VerdictsAreOfTheWholePictureInEveryLayout) {
    Lab lab(scene("still-life"), {640, 400});
    lab.ui.shown.panel = false;
    lab.ui.bench.change("", [](lab::Document& d) { d = coarseMap(d); });
    chooseLayout(lab.ui, picture::Layout::split);
    settle(lab.screen);
    const int map = wrongOf(lab, 0), volumes = wrongOf(lab, 1);
    EXPECT_GT(map, 100);
    for (const double split : {0.0, 0.2, 0.9, 1.0}) {
        lab.ui.bench.change("", [&](lab::Document& d) { d.split = split; });
        settle(lab.screen);
        if (split > 0) { EXPECT_EQ(wrongOf(lab, 0), map) << split; }
        if (split < 1) { EXPECT_EQ(wrongOf(lab, 1), volumes) << split; }
    }
    lab.ui.bench.change("", [](lab::Document& d) { d.split = 0.5; });
    chooseLayout(lab.ui, picture::Layout::diff);
    settle(lab.screen);
    EXPECT_EQ(wrongOf(lab, 0), map);
    EXPECT_EQ(wrongOf(lab, 1), volumes);
    ASSERT_TRUE(lab.screen.errors().difference());
    chooseLayout(lab.ui, picture::Layout::single);
    settle(lab.screen);
    EXPECT_EQ(wrongOf(lab, 0), map);
    // And that is what is measured of a picture of that size.
    judge::Counts measured;
    picture::Session session(lab.ui.bench.shownScene());
    picture::Slot slot = picture::Session::makeSlot("shadow-map");
    for (params::Param& param : slot.params)
        if (param.id == "resolution") params::setFromText(param, "256", "shadow-map");
    View view;
    view.camera = session.snapshot()->camera;
    view.size = lab.screen.pictureSize();
    measured = picture::judgeSlot(session, slot, view, 0).found.errors.judgement.counts;
    EXPECT_EQ(measured.wrong(), map);
}

TEST_F(ScreenTest, TheSplitLineMovesOverPicturesThatAreThere) {
    Lab lab(scene("still-life"), {640, 400});
    lab.ui.bench.change("", [](lab::Document& d) { d = coarseMap(d); });
    chooseLayout(lab.ui, picture::Layout::split);
    settle(lab.screen);
    lab::Workbench& bench = lab.ui.bench;
    const ivec2 size = lab.screen.pictureSize();
    const lab::PaneErrors before = *lab.screen.errors().errors(0);
    int moved = 0;
    for (const double split : {0.1, 0.6, 0.8}) {
        bench.setMoving(true);
        bench.change("split", [&](lab::Document& d) { d.split = split; });
        EXPECT_FALSE(bench.update(size, Deadline::max())) << "both pictures are whole: nothing is drawn for " << split;
        for (const lab::PlacedPane& placed : bench.placed(size)) {
            EXPECT_EQ(bench.requestFor(placed).view.region.size, ivec2(0));
            ++moved;
        }
    }
    EXPECT_EQ(moved, 6);
    // A camera that moves needs no more than what is seen of it.
    scene::Camera camera = bench.document().camera;
    camera.positionWorld.x += 0.1;
    bench.setCamera(camera);
    EXPECT_EQ(bench.requestFor(bench.placed(size).front()).view.region.size.x, static_cast<int>(std::lround(0.8 * size.x)));
    bench.wantVisibility({bench.placed(size).front().pane});
    EXPECT_EQ(bench.requestFor(bench.placed(size).front()).view.region.size, ivec2(0)) << "to be judged";
    EXPECT_EQ(before.counts.wrong(), lab.screen.errors().errors(0)->counts.wrong());
}

TEST_F(ScreenTest, ADifferenceIsOfTheFinishedPicturesWhateverThePanesShow) {
    Lab lab(scene("sphere-on-plane"), {640, 400});
    lab.ui.bench.change("", [](lab::Document& d) { d = coarseMap(d); });
    chooseLayout(lab.ui, picture::Layout::diff);
    settle(lab.screen);
    const std::vector<std::uint8_t> difference = pixels(lab.screen);
    ASSERT_TRUE(lab.screen.errors().difference());
    const image::Image picture = picture::PictureEncoder::read(lab.screen.errors().difference()->verdicts);
    for (const char* stage : {"outside", "truth"}) {
        lab.ui.bench.change("", [&](lab::Document& d) { d.panes[0].stage = picture::StageRef::parse(stage); });
        settle(lab.screen);
        EXPECT_EQ(lab.ui.bench.pane(0).picture().caption, "") << "no word of another picture in the title";
        ASSERT_TRUE(lab.screen.errors().difference());
        EXPECT_EQ(picture::PictureEncoder::read(lab.screen.errors().difference()->verdicts), picture) << stage;
        EXPECT_FALSE(window::looksFromOutside(lab.ui)) << "the mouse turns the camera of the picture";
    }
}

/// Cells of a magnifier whose middle has that colour on the screen.
int cellsOf(const Lab& lab, const window::Glass& glass, const vec3& colorLinear) {
    const image::Image screen = picture::PictureEncoder::read(lab.screen.picture());
    int found = 0;
    for (int y = 0; y < glass.across; ++y)
        for (int x = 0; x < glass.across; ++x)
            found += screen.at(static_cast<int>(glass.corner.x) + x * glass.cell + glass.cell / 2,
                               static_cast<int>(glass.corner.y) + y * glass.cell + glass.cell / 2) == image::encoded(colorLinear);
    return found;
}

TEST_F(ScreenTest, TheMagnifierShowsEachWrongPixelAsOneCell) {
    Lab lab(scene("still-life"), {900, 600});
    lab.ui.bench.change("", [](lab::Document& d) { d = coarseMap(d); });
    lab.ui.shown.magnifier = true;
    int looked = 0, wrongCells = 0;
    for (const bool diff : {false, true}) {
        chooseLayout(lab.ui, diff ? picture::Layout::diff : picture::Layout::single);
        chooseStage(lab.ui, {"error"});
        settle(lab.screen);
        const lab::JudgedPicture* const judged = lab.screen.errors().shownOn(lab.ui.bench.document(), 0);
        ASSERT_TRUE(judged && judged->onePixelEach);
        const image::Image verdicts = picture::PictureEncoder::read(judged->onePixelEach);
        const ivec2 size(verdicts.width, verdicts.height);
        EXPECT_NE(verdicts, picture::PictureEncoder::read(judged->verdicts)) << "in the pane they are larger";
        for (const vec3& color : {look::kFalseLit, look::kFalseShadow}) {
            // A pixel of the colour that has room around it.
            std::optional<ivec2> middle;
            for (int y = 10; y < size.y - 10 && !middle; ++y)
                for (int x = 10; x < size.x - 10 && !middle; ++x)
                    if (verdicts.at(x, y) == image::encoded(color)) middle = ivec2(x, y);
            ASSERT_TRUE(middle);
            lab.ui.lens = (dvec2(*middle) + 0.5) / dvec2(size);
            settle(lab.screen);
            const auto glass = window::glassOver(lab.screen.shownPanes().front(), *middle, lab.screen.theme());
            ASSERT_TRUE(glass);
            for (const vec3& either : {look::kFalseLit, look::kFalseShadow}) {
                int there = 0;
                for (int y = 0; y < glass->across; ++y)
                    for (int x = 0; x < glass->across; ++x)
                        there += verdicts.at(glass->firstPixel.x + x, glass->firstPixel.y + y) == image::encoded(either);
                EXPECT_EQ(cellsOf(lab, *glass, either), there);
                wrongCells += there;
            }
            ++looked;
        }
    }
    EXPECT_EQ(looked, 4);
    EXPECT_GE(wrongCells, 8);
}

// One lamp, a sharp map beside many points of it: each is judged by what it answers to.
TEST_F(ScreenTest, LiveErrorsOfAnAreaComeAtRest) {
    Lab lab(scene("cornell-room"), {640, 400});
    lab.ui.bench.change("", [](lab::Document& d) {
        for (lab::PaneState& pane : d.panes)
            pane.technique = "shadow-map";
        d.panes[1].settings["shadow-map"]["light-samples"] = "64";
        d.panes[1].stage = {"error"};
        d.layout = picture::Layout::side;
    });
    settle(lab.screen);
    const auto rmse = [&](int pane) {
        const lab::PaneErrors* const known = lab.screen.errors().errors(pane);
        return known && known->exact ? known->counts.rmse : 1.0;
    };
    EXPECT_LT(rmse(0), 0.03) << "a sharp border is right for a point";
    EXPECT_LT(rmse(1), 0.03) << "and a penumbra for its area";
    EXPECT_TRUE(lab.screen.errors().picture(1));
    EXPECT_NE(lab.screen.errors().errors(0)->counts.lit, lab.screen.errors().errors(1)->counts.lit);
}

} // namespace
} // namespace shadowlab
