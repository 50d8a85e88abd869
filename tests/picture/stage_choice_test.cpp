// STAGE, STAGE@LIGHT and pass:ID, as the command line writes them.
// SPDX-License-Identifier: MIT
#include "tests/foundation/scene/scene_files.h"
#include "tests/support/scenes.h"

#include "app/picture/session.h"

namespace shadowlab::picture {
namespace {

using scene::contains;
using scene::errorOf;

class StageChoiceTest : public ::testing::Test {
protected:
    StageChoiceTest() {
        lit.name = "room";
        lit.lights = {testing::pointLight({1, 2, 3}), testing::pointLight({3, 2, 1})};
        lit.lights[0].name = "key";
        lit.lights[1].name = "fill@home"; // a name may hold the mark itself
        dark.lights.clear();
    }
    StageKey key(const std::string& text, int defaultLight = kNoLight) const {
        return parseStage(text, volume, lit, defaultLight).key;
    }
    void expectRefused(const std::string& text, const scene::Scene& scene, const std::string& says) const {
        const Error error = errorOf([&] { parseStage(text, volume, scene, kNoLight); });
        EXPECT_EQ(error.status(), ExitStatus::usage);
        EXPECT_TRUE(contains(error.what(), says)) << error.what();
    }
    const TechniqueInfo& volume = findTechnique("shadow-volume-zfail");
    scene::Scene lit = testing::simpleScene(), dark = testing::simpleScene();
};

TEST_F(StageChoiceTest, StagesOfALight) {
    EXPECT_EQ(key("visibility"), (StageKey{"visibility", 0}));
    EXPECT_EQ(key("visibility", 1), (StageKey{"visibility", 1}));
    EXPECT_EQ(key("visibility@key", 1), (StageKey{"visibility", 0}));
    EXPECT_FALSE(parseStage("visibility", volume, lit, kNoLight).isPass);
}

TEST_F(StageChoiceTest, StagesAndPassesOfTheFrame) {
    EXPECT_EQ(key("lights-off", 1), (StageKey{"lights-off", kNoLight}));
    EXPECT_EQ(key("pass:lights-off"), (StageKey{"lights-off", kNoLight}));
    EXPECT_EQ(key("pass:light@key"), (StageKey{"light", 0}));
    EXPECT_TRUE(parseStage("pass:light", volume, lit, kNoLight).isPass);
}

TEST_F(StageChoiceTest, Refusals) {
    expectRefused("visibilty", lit, "\"visibility\"");
    expectRefused("pass:ligt", lit, "\"pass:light\"");
    expectRefused("", lit, "has no stage ''");
    expectRefused("@key", lit, "has no stage '@key'");
    expectRefused("pass:", lit, "has no stage 'pass:'");
    expectRefused("visibility@", lit, "has no light ''");
    expectRefused("visibility@kye", lit, "\"key\"");
    expectRefused("lights-off@key", lit, "does not belong to one light");
    expectRefused("visibility", dark, "needs a light");
    expectRefused("visibility@key", dark, "it has no lights");
}

TEST_F(StageChoiceTest, LightsByName) {
    EXPECT_EQ(lightIndex(lit, "key"), 0);
    EXPECT_EQ(lightIndex(lit, "fill@home"), 1);
}

} // namespace
} // namespace shadowlab::picture
