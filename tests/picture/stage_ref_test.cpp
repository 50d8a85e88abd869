// STAGE, STAGE@LIGHT and pass:ID, as the command line writes them: read, written, and looked up in a technique and a scene.
// SPDX-License-Identifier: MIT
#include "tests/foundation/scene/scene_files.h"
#include "tests/support/scenes.h"

#include "app/picture/session.h"
#include "app/picture/stage_ref.h"

namespace shadowlab::picture {
namespace {

using scene::contains;
using scene::errorOf;

TEST(StageRef, IsReadAndWrittenAlike) {
    struct Spelled {
        const char* text;
        StageRef stage;
    };
    const std::vector<Spelled> all = {{"", {}},
                                      {"visibility", {"visibility", {}, false}},
                                      {"visibility@key", {"visibility", "key", false}},
                                      {"visibility@", {"visibility", "", false}},
                                      {"visibility@fill@home", {"visibility", "fill@home", false}},
                                      {"@key", {"", "key", false}},
                                      {"pass:", {"", {}, true}},
                                      {"pass:light", {"light", {}, true}},
                                      {"pass:light@the sun", {"light", "the sun", true}},
                                      {"pass:pass:light", {"pass:light", {}, true}}};
    for (const Spelled& one : all) {
        EXPECT_EQ(StageRef::parse(one.text), one.stage) << one.text;
        EXPECT_EQ(one.stage.text(), one.text);
        EXPECT_EQ(one.stage.isPicture(), std::string_view(one.text).empty()) << one.text;
    }
    EXPECT_EQ(StageRef::parsePass("light@key"), StageRef::parse("pass:light@key"));
    EXPECT_EQ(StageRef::parse("pass:light@key").idAndLight(), "light@key");
    EXPECT_EQ(StageRef::parse("pass:light@key").ofAnyLight().text(), "pass:light");
}

TEST(StageRef, AnswersWhatItIs) {
    for (const char* id : {"truth", "error", "scanline", "shadow-outline", "mesh-edges", "outside"}) {
        EXPECT_TRUE(StageRef::parse(std::string(id) + "@key").isDerived()) << id;
        EXPECT_FALSE(StageRef::parsePass(id).isDerived()) << id;
    }
    EXPECT_FALSE(StageRef::parse("visibility").isDerived());
    EXPECT_TRUE(StageRef::parse("visibility@key").isVisibility());
    EXPECT_FALSE(StageRef::parsePass("visibility").isVisibility());
    int judged = 0;
    for (const char* id : {"", "visibility", "truth", "error", "scanline", "shadow-outline", "mesh-edges", "outside"})
        judged += StageRef::parse(id).isJudged() ? 1 : 0;
    EXPECT_EQ(judged, 3);
    EXPECT_TRUE(StageRef::parse("error").isJudged());
    EXPECT_TRUE(StageRef::parse("outside@key").isOutside());
    EXPECT_FALSE(StageRef::parse("pass:outside").isOutside());
}

class ResolveTest : public ::testing::Test {
protected:
    ResolveTest() {
        lit.name = "room";
        lit.lights = {testing::pointLight({1, 2, 3}), testing::pointLight({3, 2, 1})};
        lit.lights[0].name = "key";
        lit.lights[1].name = "fill@home"; // a name may hold the mark itself
        dark.lights.clear();
    }
    ResolvedStage resolved(const std::string& text, int defaultLight = kNoLight) const {
        return resolve(StageRef::parse(text), volume, lit, defaultLight);
    }
    StageKey key(const std::string& text, int defaultLight = kNoLight) const { return resolved(text, defaultLight).key; }
    void expectRefused(const std::string& text, const scene::Scene& scene, const std::string& says) const {
        const Error error = errorOf([&] { resolve(StageRef::parse(text), volume, scene, kNoLight); });
        EXPECT_EQ(error.status(), ExitStatus::usage);
        EXPECT_TRUE(contains(error.what(), says)) << error.what();
    }
    const TechniqueInfo& volume = findTechnique("shadow-volume-zfail");
    scene::Scene lit = testing::simpleScene(), dark = testing::simpleScene();
};

TEST_F(ResolveTest, StagesOfALight) {
    EXPECT_EQ(key("visibility"), (StageKey{"visibility", 0}));
    EXPECT_EQ(key("visibility", 1), (StageKey{"visibility", 1}));
    EXPECT_EQ(key("visibility@key", 1), (StageKey{"visibility", 0}));
    EXPECT_EQ(key("visibility@fill@home"), (StageKey{"visibility", 1}));
    EXPECT_FALSE(resolved("visibility").isPass);
    EXPECT_TRUE(resolved("visibility").isStage());
}

TEST_F(ResolveTest, StagesAndPassesOfTheFrame) {
    EXPECT_EQ(key("lights-off", 1), (StageKey{"lights-off", kNoLight}));
    EXPECT_EQ(key("pass:lights-off"), (StageKey{"lights-off", kNoLight}));
    EXPECT_EQ(key("pass:light@key"), (StageKey{"light", 0}));
    EXPECT_TRUE(resolved("pass:light").isPass);
    EXPECT_FALSE(resolved("pass:light").isStage());
    EXPECT_TRUE(resolved("").isPicture());
    EXPECT_EQ(refOf({"light", 1}, true, lit).text(), "pass:light@fill@home");
}

TEST_F(ResolveTest, Refusals) {
    expectRefused("visibilty", lit, "\"visibility\"");
    expectRefused("pass:ligt", lit, "\"pass:light\"");
    expectRefused("@key", lit, "has no stage '@key'");
    expectRefused("pass:", lit, "has no stage 'pass:'");
    expectRefused("visibility@", lit, "has no light ''");
    expectRefused("visibility@kye", lit, "\"key\"");
    expectRefused("lights-off@key", lit, "does not belong to one light; leave out '@key'");
    expectRefused("visibility", dark, "needs a light");
    expectRefused("visibility@key", dark, "it has no lights");
}

TEST_F(ResolveTest, LightsByName) {
    EXPECT_EQ(lightIndex(lit, "key"), 0);
    EXPECT_EQ(lightIndex(lit, "fill@home"), 1);
}

} // namespace
} // namespace shadowlab::picture
