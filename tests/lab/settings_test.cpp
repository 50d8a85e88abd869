// `[SLOT:]ID.PARAM=VALUE` reaches the right slots, or says why not.
// SPDX-License-Identifier: MIT
#include "app/lab/settings.h"

#include "tests/foundation/scene/scene_files.h"

namespace shadowlab::lab {
namespace {

using scene::contains;
using scene::errorOf;

class SettingsTest : public ::testing::Test {
protected:
    SettingsTest() {
        for (const char* id : {"shadow-map", "shadow-volume-zfail", "shadow-map"})
            slots.push_back(picture::Session::makeSlot(id));
    }
    std::string value(std::size_t slot, const std::string& param) {
        return params::valueText(params::find(slots[slot].params, param, "test"));
    }
    void expectRefused(const std::string& setting, const std::string& says) {
        const Error error = errorOf([&] { applySettings(slots, {setting}); });
        EXPECT_EQ(error.status(), ExitStatus::usage);
        EXPECT_TRUE(contains(error.what(), says)) << error.what();
        EXPECT_EQ(value(0, "resolution") + value(2, "resolution"), "20482048") << "changed by " << setting;
    }
    std::vector<picture::Slot> slots;
};

TEST_F(SettingsTest, WithoutASlotAllOfTheTechnique) {
    applySettings(slots, {"shadow-map.resolution=512"});
    EXPECT_EQ(value(0, "resolution"), "512");
    EXPECT_EQ(value(2, "resolution"), "512");
}

TEST_F(SettingsTest, WithASlotOnlyThatOne) {
    applySettings(slots, {"3:shadow-map.filter=hard", "2:shadow-volume-zfail.cull=false"});
    EXPECT_EQ(value(0, "filter"), "pcf");
    EXPECT_EQ(value(2, "filter"), "hard");
    EXPECT_EQ(value(1, "cull"), "false");
}

TEST_F(SettingsTest, TheLaterOneCounts) {
    applySettings(slots, {"1:shadow-map.resolution=512", "shadow-map.resolution=256", "3:shadow-map.resolution=128"});
    EXPECT_EQ(value(0, "resolution"), "256");
    EXPECT_EQ(value(2, "resolution"), "128");
}

TEST_F(SettingsTest, OfWhatHasNoEffectOneSentence) {
    EXPECT_TRUE(settingsWithoutEffect(slots).empty());
    applySettings(slots, {"shadow-map.filter=hard", "shadow-map.pcf-radius=3"}); // of both shadow maps
    const std::vector<std::string> sentences = settingsWithoutEffect(slots);
    ASSERT_EQ(sentences.size(), 1u);
    EXPECT_TRUE(contains(sentences[0].c_str(), "'shadow-map.pcf-radius=3' has no effect")) << sentences[0];
    applySettings(slots, {"shadow-map.filter=pcf"});
    EXPECT_TRUE(settingsWithoutEffect(slots).empty());
}

TEST_F(SettingsTest, NumbersAreReadTheSameInEveryLocale) {
    applySettings(slots, {"shadow-map.slope-bias=1.5"});
    EXPECT_EQ(value(0, "slope-bias"), "1.5");
    expectRefused("shadow-map.slope-bias=1,5", "'1,5' is not a number");
}

TEST_F(SettingsTest, Refusals) {
    for (const char* text :
         {"", "=", ".", ":", "shadow-map", "shadow-map.resolution", "shadow-map=512", "resolution=51.2", "=a.b"})
        EXPECT_EQ(errorOf([&] { applySettings(slots, {text}); }).status(), ExitStatus::usage) << text;
    expectRefused("shadow-map.resolution=", "64..32768 texels");
    expectRefused("shadow-map.resolution=32769", "64..32768 texels");
    expectRefused("shadow-map.resolution=1e999", "64..32768");
    expectRefused("shadow-map.resolution= 512", "is not a whole number");
    expectRefused("shadow-map.resolutions=512", "did you mean \"resolution\"?");
    expectRefused("shadowmap.resolution=512", "did you mean \"shadow-map\"?");
    expectRefused("4:shadow-map.resolution=512", "from 1 to 3");
    expectRefused("2:shadow-map.resolution=512", "no slot 2 shows shadow-map");
    expectRefused("-1:shadow-map.resolution=512", "no slot number");
    expectRefused("1.5:shadow-map.resolution=512", "");
    expectRefused("99999999999:shadow-map.resolution=512", "no slot number");
    expectRefused(":shadow-map.resolution=512", "no slot number");
    expectRefused("unshadowed.cull=true", "no slot shows unshadowed");
}

} // namespace
} // namespace shadowlab::lab
