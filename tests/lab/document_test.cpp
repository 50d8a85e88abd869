// Undo, steps, and the command line that makes the picture on show.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "app/course/capture_arguments.h"
#include "app/lab/document.h"
#include "app/picture/steps/stepping.h"
#include "app/window/window_settings.h"
#include "tests/foundation/scene/scene_files.h"

namespace shadowlab::lab {
namespace {

lab::Document someDocument() {
    auto scene = std::make_shared<scene::Scene>();
    scene->name = "some";
    scene->lights.resize(2);
    scene->lights[0].name = "key";
    scene->lights[1].name = "the sun";
    return lab::newDocument(scene, "some");
}

TEST(UndoHistory, ARunOfOneGestureIsOneStep) {
    lab::UndoHistory history;
    lab::Document document = someDocument();
    for (const double split : {0.4, 0.3, 0.2}) {
        history.remember(document, "split");
        document.split = split;
    }
    history.endGesture();
    history.remember(document, "split");
    document.split = 0.1;
    document = history.undo(document);
    EXPECT_EQ(document.split, 0.2);
    document = history.undo(document);
    EXPECT_EQ(document.split, 0.5) << "three changes of one drag";
    EXPECT_FALSE(history.canUndo());
    document = history.redo(history.redo(document));
    EXPECT_EQ(document.split, 0.1);
    EXPECT_FALSE(history.canRedo());
    document = history.undo(document);
    history.remember(document, "");
    EXPECT_FALSE(history.canRedo()) << "a new change ends what was undone";
}

TEST(Stepping, GoesThroughThePassesAndOutAtBothEnds) {
    const lab::Document document = someDocument();
    const scene::Scene& scene = *document.scene;
    const std::vector<StageKey> passes = {{"lights-off", kNoLight}, {"light", 0}, {"light", 1}};
    const auto stepped = [&](const char* stage, int by) {
        return picture::stepped(picture::StageRef::parse(stage), passes, scene, 0, by).text();
    };
    const auto stepOf = [&](const char* stage, int light) {
        return picture::stepOf(picture::StageRef::parse(stage), passes, scene, light);
    };
    std::string stage;
    std::vector<std::string> seen;
    for (int i = 0; i < 5; ++i)
        seen.push_back(stage = stepped(stage.c_str(), 1));
    EXPECT_EQ(seen, (std::vector<std::string>{"pass:lights-off", "pass:light@key", "pass:light@the sun", "",
                                              "pass:lights-off"}));
    EXPECT_EQ(stepped("", -1), "pass:light@the sun");
    EXPECT_EQ(stepped("pass:lights-off", -1), "");
    EXPECT_EQ(stepOf("pass:light", 1), 2u) << "of the light that is asked about";
    EXPECT_FALSE(stepOf("visibility", 0));
    EXPECT_EQ(stepped("pass:gone", 1), "pass:lights-off");
    EXPECT_TRUE(picture::stepped({}, {}, scene, 0, 1).isPicture());
}

TEST(Stepping, AStepThatWritesNoPictureIsShownByItsStage) {
    lab::Document document = someDocument();
    const auto shown = [&](const char* technique, const char* pass) {
        const TechniqueInfo& info = findTechnique(technique);
        const picture::ResolvedStage choice = picture::shownInStep(
            picture::resolve(picture::StageRef::parse(pass), info, *document.scene, 1), info, 1);
        return choice.key.id + (choice.key.light == kNoLight ? "" : std::to_string(choice.key.light)) +
               (choice.isPass ? " itself" : "");
    };
    EXPECT_EQ(shown("shadow-volume-zfail", "pass:volumes-back@key"), "stencil-back0");
    EXPECT_EQ(shown("shadow-volume-zfail", "pass:light@key"), "light0 itself");
    EXPECT_EQ(shown("shadow-map", "pass:depth"), "light-depth1") << "of the light that is asked about";
    EXPECT_EQ(shown("ray-traced", "pass:visibility"), "shadow-rays1");
    EXPECT_EQ(shown("planar", "pass:tag-receivers"), "stencil-tags") << "of no light";
    const TechniqueInfo& rays = findTechnique("ray-traced");
    EXPECT_TRUE(picture::shownInStep({{"visibility", kNoLight}, true}, rays, kNoLight).isPass)
        << "no lights, no answers of rays";

    document.layout = picture::Layout::single;
    document.panes[0].stage = picture::StageRef::parse("pass:depth@the sun");
    const std::string line = course::asCommandLine(course::captureArguments(document, "s.json", "o.png", {10, 20}));
    EXPECT_NE(line.find("--stage 'light-depth@the sun'"), std::string::npos) << line;
}

TEST(CaptureWords, SayAllThatThePictureDependsOn) {
    lab::Document document = someDocument();
    document.split = 0.3125;
    document.light = 1;
    document.panes[0].stage = picture::StageRef::parse("error@the sun");
    document.panes[1].settings["shadow-volume-zfail"]["caps"] = "false";
    document.panes[1].settings["shadow-map"]["resolution"] = "64"; // of a technique that is not shown there
    const std::string line = course::asCommandLine(course::captureArguments(document, "/a b/scene.json", "out.png", {1000, 500}));
    EXPECT_EQ(line, "capture '/a b/scene.json' -o out.png -t shadow-map,shadow-volume-zfail --size 1000x500 "
                    "--layout split --split 0.3125 --enlarge true --light 'the sun' --stage '1:error@the sun' "
                    "--set 2:shadow-volume-zfail.caps=false");
    document.layout = picture::Layout::diff; // it is of the finished pictures, whatever the panes show
    EXPECT_EQ(course::asCommandLine(course::captureArguments(document, "s.json", "o.png", {10, 20})),
              "capture s.json -o o.png -t shadow-map,shadow-volume-zfail --size 10x20 --layout diff --enlarge true --light 'the sun' "
              "--set 2:shadow-volume-zfail.caps=false");
    document.layout = picture::Layout::single;
    document.active = 2;
    EXPECT_EQ(course::asCommandLine(course::captureArguments(document, "s.json", "o.png", {10, 20})),
              "capture s.json -o o.png -t ray-traced --size 10x20 --light 'the sun'");
    EXPECT_EQ(course::asCommandLine({"it's"}), "'it'\\''s'");
}

// A place is the same direction from the camera, whatever the shape of the picture: a ball stays under its mark when a pane becomes wider.
TEST(PickedPlace, IsTheSamePointOfTheSceneInPicturesOfAnyShape) {
    const scene::Camera camera = someDocument().camera;
    const dvec3 pointWorld = camera.targetWorld + dvec3(0.3, 0.2, -0.1);
    const auto shareIn = [&](dvec2 size) {
        const dvec4 clip = scene::clipFromView(camera, size.x / size.y) * (scene::viewFromWorld(camera) * dvec4(pointWorld, 1.0));
        return dvec2(0.5 + 0.5 * clip.x / clip.w, 0.5 - 0.5 * clip.y / clip.w);
    };
    const dvec2 first(1280, 720), place = lab::placeOf(shareIn(first), first);
    EXPECT_EQ(place, shareIn(first)) << "in a picture of 16 : 9 a place is its share";
    for (const dvec2 size : {dvec2(640, 480), dvec2(1000, 300), dvec2(400, 900)}) {
        const dvec2 share = lab::shareOf(place, size);
        EXPECT_NEAR(share.x, shareIn(size).x, 1e-9); // rounding of doubles
        EXPECT_NEAR(share.y, shareIn(size).y, 1e-9);
        EXPECT_NEAR(lab::placeOf(share, size).x, place.x, 1e-9);
    }
    EXPECT_TRUE(lab::isInPicture({0.95, 0.5}, {1600, 900}));
    EXPECT_FALSE(lab::isInPicture({0.95, 0.5}, {900, 900})) << "a square picture ends before it";
}

// A picked pixel is a place in the picture: in a picture of another size it is another pixel.
TEST(CaptureWords, NameAPickedPixelWhereItsRaysAreSeen) {
    lab::Document document = someDocument();
    document.layout = picture::Layout::single;
    document.active = 2;
    document.picked = lab::placeOf({0.255, 0.75}, {100, 40});
    const auto line = [&](ivec2 size) { return course::asCommandLine(course::captureArguments(document, "s.json", "o.png", size)); };
    EXPECT_EQ(line({100, 40}).find("--pixel"), std::string::npos);
    document.panes[2].stage = {"outside"};
    EXPECT_NE(line({100, 40}).find(" --pixel 25,30"), std::string::npos) << line({100, 40});
    EXPECT_NE(line({200, 60}).find(" --pixel 63,45"), std::string::npos) << line({200, 60});
    document.layout = picture::Layout::grid; // each of its pictures is half as wide and half as high
    document.panes[0].stage = {"outside"};
    EXPECT_NE(line({200, 80}).find(" --pixel 25,30"), std::string::npos) << line({200, 80});
    EXPECT_EQ(lab::pixelAt(lab::placeOf({1, 1}, {100, 40}), {100, 40}), ivec2(99, 39));
}

TEST(CaptureWords, NameBothPickedPixelsWhereAStageIsAboutThem) {
    lab::Document document = someDocument();
    document.layout = picture::Layout::single;
    document.active = 0;
    document.picked = lab::placeOf({0.255, 0.75}, {100, 40});
    document.partner = dvec2(0.5, 0.1); // the middle column of any picture
    document.panes[0].technique = "radiosity";
    const auto line = [&] { return course::asCommandLine(course::captureArguments(document, "s.json", "o.png", {100, 40})); };
    EXPECT_EQ(line().find("--p"), std::string::npos) << line();
    document.panes[0].stage = {"row-sums"}; // of all patches
    EXPECT_EQ(line().find("--p"), std::string::npos) << line();
    for (const char* stage : {"form-factors", "outside", "outside@the sun"}) {
        document.panes[0].stage = picture::StageRef::parse(stage);
        EXPECT_NE(line().find(" --pixel 25,30 --partner 50,4 "), std::string::npos) << line();
    }
    document.partner.reset();
    EXPECT_EQ(line().find("--partner"), std::string::npos) << line();
}

TEST(WindowMemory, ComesBackAndABrokenFileIsAsNone) {
    const scene::TempFolder folder;
    const auto file = folder.path() / "deep" / "window.json";
    EXPECT_EQ(window::readWindowMemory(file), window::WindowMemory{});
    const window::WindowMemory memory{{1024, 768}, false, true, true, false};
    window::writeWindowMemory(file, memory);
    EXPECT_EQ(window::readWindowMemory(file), memory);
    for (const std::string text : {"", "[1, 2", "[]", R"({"width": "wide", "panel": 3})"})
        EXPECT_EQ(window::readWindowMemory(folder.write("w.json", text)), window::WindowMemory{}) << text;
    EXPECT_EQ(window::readWindowMemory(folder.write("w.json", R"({"width": -5, "height": 99999999})")).size, ivec2(320, 7680));
}

} // namespace
} // namespace shadowlab::lab
