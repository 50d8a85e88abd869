// A step before any light is on is shown brighter, by a factor that is said; counts are painted on the grey scene.
// SPDX-License-Identifier: MIT
#include <set>

#include "app/context/assets.h"
#include "app/picture/panel.h"
#include "app/picture/steps/step_lift.h"
#include "app/picture/steps/stepping.h"
#include "techniques/foundation/scene/load/load.h"
#include "tests/support/gl_fixture.h"

namespace shadowlab {
namespace {

class StepLiftTest : public testing::GlTest {
protected:
    static constexpr ivec2 kSize{320, 180};
    static scene::Snapshot stillLife() {
        return scene::loadScene("still-life", {.assetsRoot = context::assetsRoot(), .allowed = {}, .limits = {}});
    }
    /// The picture of a step, as step mode has it or as it is.
    static picture::Panel panelOf(const std::string& technique, const std::string& pass, bool lifts) {
        const scene::Snapshot scene = stillLife();
        picture::Session session(scene);
        picture::Slot slot = picture::Session::makeSlot(technique);
        picture::Cell cell{0, 0, kSize.x, kSize.y, kSize, 0};
        picture::PanelRequest request;
        const int light = passInfo(slot.info->passes, pass).perLight ? 0 : kNoLight;
        request.stage = picture::shownInStep({{pass, light}, true}, *slot.info, 0);
        request.camera = scene->camera;
        request.liftsSteps = lifts;
        return picture::renderPanel(session, slot, picture::PictureEncoder(), cell, request).panel;
    }
    static double meanLevel(const image::Image& picture) {
        double sum = 0;
        for (std::size_t i = 0; i < picture.rgba.size(); i += 4)
            sum += picture.rgba[i + 1];
        return sum * 4 / static_cast<double>(picture.rgba.size());
    }
};

TEST_F(StepLiftTest, WithAllLightsOffThePictureIsLiftedAndSaysSo) {
    int lifted = 0;
    for (const char* technique : {"shadow-map", "shadow-volume-zpass", "lecture-shadow-map", "lecture-zpass"}) {
        const picture::Panel as = panelOf(technique, "lights-off", false), shown = panelOf(technique, "lights-off", true);
        EXPECT_EQ(as.note, "") << technique;
        EXPECT_EQ(shown.note, "shown 8 times brighter") << technique;
        EXPECT_LT(meanLevel(as.picture), 70) << technique;     // of 255: nearly black on a projector
        EXPECT_GT(meanLevel(shown.picture), 120) << technique; // about the middle
        ++lifted;
    }
    EXPECT_EQ(lifted, 4);
}

TEST_F(StepLiftTest, WithALightOnItIsShownAsItIs) {
    const picture::Panel as = panelOf("shadow-map", "light", false), shown = panelOf("shadow-map", "light", true);
    EXPECT_EQ(shown.note, "");
    EXPECT_EQ(as.picture.rgba, shown.picture.rgba);
}

TEST_F(StepLiftTest, UnderTheCountsTheSceneIsSeen) {
    const picture::Panel counts = panelOf("shadow-volume-zpass", "volumes", true);
    ASSERT_EQ(counts.kind, StageKind::count);
    std::set<std::uint8_t> greys;
    int grey = 0, coloured = 0;
    for (std::size_t i = 0; i < counts.picture.rgba.size(); i += 4) {
        const int red = counts.picture.rgba[i], blue = counts.picture.rgba[i + 2];
        if (std::abs(red - blue) <= 2) { // the palette's middle is nearly neutral
            ++grey;
            greys.insert(counts.picture.rgba[i]);
        } else {
            ++coloured;
        }
    }
    EXPECT_GT(grey, 10000);
    EXPECT_GT(coloured, 1000);
    EXPECT_GT(greys.size(), 50u) << "a flat ground has one or two";
}

} // namespace
} // namespace shadowlab
