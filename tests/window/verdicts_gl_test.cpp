// The verdicts in the window: of whole pictures, the same in every layout, and seen pixel by pixel under the magnifier.
// SPDX-License-Identifier: MIT
#include <cmath>
#include <optional>

#include "app/picture/judged_slot.h"
#include "app/window/panels/panels.h"
#include "techniques/foundation/base/look.h"
#include "tests/window/screen_fixture.h"

namespace shadowlab {
namespace {

using testing::Lab;

class WindowVerdictsTest : public testing::ScreenFixture {};

TEST_F(WindowVerdictsTest, LiveErrorsAreThoseOfTheTechniques) {
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

TEST_F(WindowVerdictsTest, VerdictsAreOfTheWholePictureInEveryLayout) {
    Lab lab(scene("still-life"), {1280, 720});
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

TEST_F(WindowVerdictsTest, NoVerdictStandsUnderAnotherTechniqueLightOrPicture) {
    Lab lab(scene("three-lights"), {640, 400});
    lab.ui.bench.change("", [](lab::Document& d) { d = coarseMap(d); });
    const auto isForgotten = [&](int pane, const auto& change) {
        settle(lab.screen);
        EXPECT_TRUE(lab.screen.errors().errors(pane));
        change();
        lab.screen.frame(0.01); // too short for a new one: only what rests for a while is judged
        return lab.screen.errors().errors(pane) == nullptr;
    };
    EXPECT_TRUE(isForgotten(0, [&] { chooseTechnique(lab.ui, "unshadowed"); }));
    EXPECT_TRUE(isForgotten(1, [&] { lab.ui.bench.change("", [](lab::Document& d) { d.light = 1; }); }));
    const auto moveOn = [](lab::Document& d) { d.camera.positionWorld.x += 0.01; };
    EXPECT_TRUE(isForgotten(1, [&] {
        lab::Document another = lab.ui.bench.document();
        moveOn(another); // the very same one may be judged again at once
        lab.ui.bench.showDocument(another);
    }));
    // What only moved keeps it until a newer one comes: a number that vanishes all the time cannot be read.
    EXPECT_FALSE(isForgotten(1, [&] { lab.ui.bench.change("", moveOn); }));
}

TEST_F(WindowVerdictsTest, TheSplitLineMovesOverPicturesThatAreThere) {
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

TEST_F(WindowVerdictsTest, ADifferenceIsOfTheFinishedPicturesWhateverThePanesShow) {
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

TEST_F(WindowVerdictsTest, TheMagnifierShowsEachWrongPixelAsOneCell) {
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
TEST_F(WindowVerdictsTest, LiveErrorsOfAnAreaComeAtRest) {
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

// What takes its time leaves the picture before in its place: the pane says so, and says nothing of that picture's time.
TEST_F(WindowVerdictsTest, APictureThatIsNotYetWhatItsTitleSaysIsMarked) {
    Lab lab(scene("cornell-room"), {640, 400});
    chooseLayout(lab.ui, picture::Layout::single);
    settle(lab.screen);
    EXPECT_FALSE(lab.ui.bench.pane(0).showsAnother());
    EXPECT_EQ(window::progressOf(lab.ui, lab.screen.errors(), 0).front(), "");
    const std::vector<std::uint8_t> before = pixels(lab.screen);
    lab.screen.setPatience(std::chrono::milliseconds(0));
    lab.ui.bench.change("", [](lab::Document& d) { d.panes[0].technique = "lecture-radiosity"; });
    lab.screen.frame(0.03);
    ASSERT_TRUE(lab.ui.bench.pane(0).showsAnother()) << "form factors are not found in no time";
    EXPECT_NE(window::progressOf(lab.ui, lab.screen.errors(), 0).front().find(" %"), std::string::npos);
    const std::vector<std::uint8_t> marked = pixels(lab.screen);
    const std::size_t middle = (static_cast<std::size_t>(250) * 640 + 60) * 4; // beside the note, rows from the bottom or the top
    EXPECT_LT(marked[middle], before[middle]) << "dimmed";
    lab.screen.setPatience(std::chrono::hours(1));
    settle(lab.screen);
    EXPECT_FALSE(lab.ui.bench.pane(0).showsAnother());
}

} // namespace
} // namespace shadowlab
