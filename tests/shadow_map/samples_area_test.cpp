// Which shadow maps answer to a light's area: those that average over its points, and those that guess its penumbra.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "app/lab/settings.h"
#include "app/picture/session.h"
#include "tests/support/area_lights.h"
#include "tests/support/scenes.h"

namespace shadowlab::shadow_map {
namespace {

/// One digit for each light: a point, a sun, a spot, a panel and a ball.
std::string answers(const std::vector<std::string>& settings) {
    std::vector<picture::Slot> slots;
    slots.push_back(picture::Session::makeSlot("shadow-map"));
    lab::applySettings(slots, settings);
    const scene::Scene scene = testing::everyKindOfLight();
    std::string text;
    for (int light = 0; light < 5; ++light)
        text += slots[0].technique->samplesArea(scene, light) ? '1' : '0';
    return text;
}

TEST(SamplesArea, ManyPointsAndPenumbrasDo) {
    EXPECT_EQ(answers({}), "00000");
    EXPECT_EQ(answers({"shadow-map.light-samples=1"}), "00000");
    EXPECT_EQ(answers({"shadow-map.light-samples=2"}), "00011");
    EXPECT_EQ(answers({"shadow-map.filter=pcss"}), "00011");
    EXPECT_EQ(answers({"shadow-map.filter=disc"}), "00000");
}

TEST(SamplesArea, OtherTechniquesModelAPoint) {
    const scene::Scene scene = testing::everyKindOfLight();
    for (const char* technique : {"unshadowed", "shadow-map-exact", "shadow-map-alias-free", "shadow-volume",
                                  "shadow-volume-zfail", "shadow-volume-zpass"})
        for (int light = 0; light < 5; ++light)
            EXPECT_FALSE(picture::Session::makeSlot(technique).technique->samplesArea(scene, light)) << technique;
}

} // namespace
} // namespace shadowlab::shadow_map
