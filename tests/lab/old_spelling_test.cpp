// What people have kept goes on working: `shadow-map.exact=true` and `shadow-map.alias-free=true` name techniques now.
// SPDX-License-Identifier: MIT
#include "app/lab/old_spelling.h"

#include "app/lab/settings.h"
#include "tests/foundation/scene/scene_files.h"

namespace shadowlab::lab {
namespace {

using scene::contains;
using scene::errorOf;
using Texts = std::vector<std::string>;

std::vector<std::string> notes;

class OldSpellingTest : public ::testing::Test {
protected:
    OldSpellingTest() {
        notes.clear();
        tellOldSpelling([](std::string_view sentence) { notes.emplace_back(sentence); });
    }
    ~OldSpellingTest() override { tellOldSpelling(nullptr); }

    /// What both are now; the settings can be applied to the techniques.
    void expectToday(const Texts& techniques, const Texts& settings, const Texts& techniquesNow,
                     const Texts& settingsNow, const Texts& stages = {}) {
        Texts technique = techniques, setting = settings;
        respell(technique, stages, setting);
        EXPECT_EQ(technique, techniquesNow) << ::testing::PrintToString(settings);
        EXPECT_EQ(setting, settingsNow) << ::testing::PrintToString(settings);
        std::vector<picture::Slot> slots;
        for (const std::string& id : technique)
            slots.push_back(picture::Session::makeSlot(id));
        EXPECT_NO_THROW(applySettings(slots, setting)) << ::testing::PrintToString(setting);
        ++compared_;
    }
    int compared_ = 0;
};

TEST_F(OldSpellingTest, ASwitchIsATechnique) {
    expectToday({"shadow-map"}, {"shadow-map.exact=true"}, {"shadow-map-exact"}, {});
    expectToday({"shadow-map"}, {"1:shadow-map.alias-free=true"}, {"shadow-map-alias-free"}, {});
    expectToday({"shadow-map"}, {"shadow-map.exact=true", "shadow-map.alias-free=true"}, {"shadow-map-alias-free"}, {});
    EXPECT_EQ(compared_, 3);
}

TEST_F(OldSpellingTest, OffIsTheShadowMapAndOfTwoTheLaterCounts) {
    expectToday({"shadow-map"}, {"shadow-map.exact=false", "shadow-map.filter=hard"}, {"shadow-map"},
                {"shadow-map.filter=hard"});
    expectToday({"shadow-map"}, {"shadow-map.exact=true", "shadow-map.filter=hard", "shadow-map.exact=false"},
                {"shadow-map"}, {"shadow-map.filter=hard"});
    EXPECT_EQ(compared_, 2);
    EXPECT_TRUE(notes.empty());
}

TEST_F(OldSpellingTest, OtherSettingsGoWhereTheyAreKnown) {
    expectToday({"shadow-map"}, {"shadow-map.resolution=512", "shadow-map.exact=true", "shadow-map.filter=hard"},
                {"shadow-map-exact"}, {"1:shadow-map-exact.resolution=512"});
    expectToday({"shadow-map"}, {"shadow-map.alias-free=true", "shadow-map.resolution=512"}, {"shadow-map-alias-free"},
                {});
    EXPECT_EQ(compared_, 2);
}

TEST_F(OldSpellingTest, EverySlotHasItsOwn) {
    expectToday({"shadow-map", "planar", "shadow-map"},
                {"3:shadow-map.exact=true", "shadow-map.resolution=512", "planar.cull=false"},
                {"shadow-map", "planar", "shadow-map-exact"},
                {"1:shadow-map.resolution=512", "3:shadow-map-exact.resolution=512", "planar.cull=false"});
    EXPECT_EQ(compared_, 1);
}

TEST_F(OldSpellingTest, AStageThatMovedTakesItsTechniqueAlong) {
    expectToday({"shadow-map", "shadow-map"}, {}, {"shadow-map-exact", "shadow-map-alias-free"}, {},
                {"traced", "eye-samples"});
    expectToday({"shadow-map"}, {}, {"shadow-map"}, {}, {"comparison"});
    expectToday({"shadow-map"}, {"shadow-map.exact=true"}, {"shadow-map-alias-free"}, {}, {"eye-samples"});
    EXPECT_EQ(compared_, 3);
}

TEST_F(OldSpellingTest, WhatIsNotOldStaysAsItIs) {
    const Texts techniques = {"shadow-map", "shadow-map-exact", "no-technique"};
    Texts now = techniques,
          settings = {"shadow-map.resolution=512", "2:shadow-map-exact.cull=false", "nonsense", "4:a.b=c"};
    const Texts before = settings;
    respell(now, {}, settings);
    EXPECT_EQ(now, techniques);
    EXPECT_EQ(settings, before);
    EXPECT_TRUE(notes.empty());
}

TEST_F(OldSpellingTest, FaultsAreStillFaults) {
    std::vector<picture::Slot> slots;
    slots.push_back(picture::Session::makeSlot("shadow-map-exact"));
    const Texts settings = {"shadow-map.exact=true", "shadow-map.no-such=1", "shadow-map.resolution=7"};
    const OldSpelling spelling({"shadow-map"}, {}, settings);
    EXPECT_TRUE(contains(errorOf([&] { applySettings(slots, spelling.today(settings[1])); }).what(), "no-such"));
    EXPECT_TRUE(
        contains(errorOf([&] { applySettings(slots, spelling.today(settings[2])); }).what(), "64..32768 texels"));
    const OldSpelling neither({"shadow-map"}, {}, {"shadow-map.exact=perhaps"});
    EXPECT_TRUE(
        contains(errorOf([&] { static_cast<void>(neither.today("shadow-map.exact=perhaps")); }).what(), "false|true"));
}

/// A deck of forty pictures says it once.
TEST_F(OldSpellingTest, ANoteIsMadeOnce) {
    for (int time = 0; time < 3; ++time) {
        const OldSpelling spelling({"shadow-map", "shadow-map"}, {"", "traced"}, {"1:shadow-map.exact=true"});
        EXPECT_EQ(spelling.techniques(), Texts({"shadow-map-exact", "shadow-map-exact"}));
    }
    EXPECT_EQ(notes, Texts({"shadow-map's exact=true is now the technique shadow-map-exact",
                            "shadow-map's stage traced is now one of the technique shadow-map-exact"}));
}

} // namespace
} // namespace shadowlab::lab
