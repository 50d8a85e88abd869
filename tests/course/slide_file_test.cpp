// What is on show, saved as a slide and read back: the same state; and decks that slides are added to lose nothing.
// SPDX-License-Identifier: MIT
#include "app/course/slide_file.h"

#include <gtest/gtest.h>

#include "app/context/assets.h"
#include "app/course/slide_stops.h"
#include "techniques/foundation/base/error.h"
#include "techniques/foundation/scene/load/file_access.h"
#include "tests/foundation/scene/scene_files.h"

namespace shadowlab::course {
namespace {

const scene::LoadOptions kLoading{.assetsRoot = context::assetsRoot(), .allowed = {}, .limits = {}};

lab::Document shown(const std::string& sceneName) {
    lab::Document document = lab::newDocument(scene::loadScene(sceneName, kLoading), sceneName);
    document.camera.positionWorld += dvec3(0.1, 1.0 / 3, -0.7); // digits that only all of them bring back
    return document;
}

class SlideFileTest : public ::testing::Test {
protected:
    SavedSlide save(const lab::Document& document) { return saveSlide(document, *document.scene, folder_.path(), kLoading); }
    /// The last slide of the deck, as the window shows it.
    lab::Document readBack() {
        Deck deck((folder_.path() / kSavedDeck).string(), kLoading);
        const std::vector<SlideStop> stops = stopsOf(deck.read(deck.slides().size() - 1));
        EXPECT_EQ(stops.size(), 1u);
        return stops.front().document;
    }
    /// All that is seen of both is equal. Panes that the layout does not show are no part of a slide.
    static void expectSame(const lab::Document& saved, lab::Document read) {
        const int count = saved.layout == picture::Layout::single ? 1 : lab::shownPanes(saved.layout);
        for (int i = 0; i < count; ++i) {
            const lab::PaneState& was =
                saved.panes[static_cast<std::size_t>(saved.layout == picture::Layout::single ? saved.active : i)];
            const lab::PaneState& is = read.panes[static_cast<std::size_t>(i)];
            EXPECT_EQ(was.technique, is.technique);
            EXPECT_EQ(was.stage.text(), is.stage.text());
            EXPECT_EQ(was.values(), is.values());
        }
        EXPECT_EQ(saved.camera, read.camera);
        EXPECT_EQ(saved.layout, read.layout);
        EXPECT_EQ(saved.light, read.light);
        EXPECT_EQ(saved.picked, read.picked);
        EXPECT_EQ(saved.partner, read.partner);
        if (saved.layout == picture::Layout::split) {
            EXPECT_EQ(saved.split, read.split);
        }
        EXPECT_EQ(saved.scene->lights, read.scene->lights);
    }
    scene::TempFolder folder_;
};

TEST_F(SlideFileTest, EveryStateComesBackAsItWas) {
    std::vector<lab::Document> states;
    states.push_back(shown("still-life")); // the first look: split in the middle
    states.back().split = 0.3;
    states.push_back(shown("three-lights"));
    states.back().layout = picture::Layout::single;
    states.back().active = 1;
    states.back().light = 2;
    states.back().panes[1] = {
        "shadow-map", {"light-depth"}, {{"shadow-map", {{"resolution", "256"}, {"filter", "hard"}}}}};
    states.push_back(shown("still-life")); // in the middle of an algorithm, in two panes
    states.back().layout = picture::Layout::side;
    states.back().panes[0].stage = picture::StageRef::parse("pass:depth@key");
    states.back().panes[1].stage = picture::StageRef::parse("pass:lights-off");
    states.push_back(shown("cornell-room"));
    states.back().layout = picture::Layout::grid;
    states.back().picked = dvec2(0.25, 2.0 / 3);
    states.back().partner = dvec2(0.1, 0.7);
    states.back().panes[2] = {"radiosity", {"form-factors"}, {}};
    states.push_back(shown("billiards"));
    states.back().layout = picture::Layout::diff;
    states.push_back(shown("billiards"));
    states.back().layout = picture::Layout::single;
    states.back().panes[0] = {"shadow-volume", {"outside"}, {}};
    states.back().outsideCamera.positionWorld = {3, 4, 1.0 / 7};
    for (std::size_t i = 0; i < states.size(); ++i) {
        const SavedSlide saved = save(states[i]);
        EXPECT_TRUE(saved.sceneFile.empty()) << "the built-in scene is named";
        const lab::Document read = readBack();
        expectSame(states[i], read);
        if (i + 1 == states.size()) {
            EXPECT_EQ(read.outsideCamera, states[i].outsideCamera);
        }
    }
    EXPECT_EQ(Deck((folder_.path() / kSavedDeck).string(), kLoading).slides(),
              (std::vector<std::string>{"still-life-1", "three-lights-1", "still-life-2", "cornell-room-1",
                                        "billiards-1", "billiards-2"}));
}

TEST_F(SlideFileTest, AChangedSceneIsSavedBesideTheDeck) {
    lab::Document document = shown("still-life");
    std::vector<scene::Light> lights = document.scene->lights;
    ASSERT_FALSE(lights.empty());
    lights[0].positionWorld.x += 0.25;
    document.scene = scene::withLights(document.scene, lights);
    const SavedSlide saved = save(document);
    EXPECT_EQ(saved.sceneFile, folder_.path() / "still-life-1.json");
    expectSame(document, readBack());
    EXPECT_EQ(save(document).name, "still-life-2") << "what is there is not written over";
}

TEST_F(SlideFileTest, WhatADeckHasStaysAsItIs) {
    const std::string deck = "// mine ] \" \n{\n  \"title\": \"A ] \\\" B\", /* ] */\n  \"slides\": [\n"
                             "    {\"name\": \"a\", \"title\": \"]}\", \"text\": [\"[\"]} // the last ]\n"
                             "    /* and ] \" this */ ], \"subtitle\": \"end\"\n}\n";
    const std::string more = withSlide(deck, "deck.json", "{\n  \"name\": \"b\"\n}");
    const std::string added = ",\n    {\n      \"name\": \"b\"\n    }";
    const std::size_t at = more.find(added);
    ASSERT_NE(at, std::string::npos) << more;
    EXPECT_EQ(more.substr(0, at) + more.substr(at + added.size()), deck);
    folder_.write("d.json", withSlide(deck, "d.json", R"({"name": "b", "title": "t", "text": ["x"]})"));
    EXPECT_EQ(Deck((folder_.path() / "d.json").string(), kLoading).slides(), (std::vector<std::string>{"a", "b"}));
}

TEST_F(SlideFileTest, ADeckThatCannotBeReadIsNotTouched) {
    folder_.write(kSavedDeck, "{\"title\": \"broken\", \"slides\": [");
    try {
        save(shown("still-life"));
        FAIL() << "it was written";
    } catch (const Error& error) {
        EXPECT_NE(std::string(error.what()).find("slides.json:1:"), std::string::npos) << error.what();
    }
    EXPECT_EQ(scene::readFile(folder_.path() / kSavedDeck, 1000), "{\"title\": \"broken\", \"slides\": [");
}

} // namespace
} // namespace shadowlab::course
