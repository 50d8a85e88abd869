// Before the shares of lights with an area are there, their centres are: a preview.
// SPDX-License-Identifier: MIT
#include <chrono>

#include <gtest/gtest.h>

#include "app/context/assets.h"
#include "techniques/foundation/scene/load/load.h"
#include "techniques/radiosity/lights/pixel_light.h"

namespace shadowlab::radiosity {
namespace {

scene::Snapshot roomWithLamps() {
    return scene::loadScene("room-with-lamps", {.assetsRoot = context::assetsRoot(), .allowed = {}, .limits = {}});
}

View viewOf(const scene::Snapshot& scene) {
    View view;
    view.camera = scene->camera;
    view.size = {160, 90};
    return view;
}

// In slices of no time at all each call does the least work there is.
TEST(PixelLightPreviewTest, CentresComeFirstAndEndAsWithoutDeadline) {
    const scene::Snapshot scene = roomWithLamps();
    const View view = viewOf(scene);
    const int lights = static_cast<int>(scene->lights.size());
    PixelLight whole, sliced;
    ASSERT_TRUE(whole.advance(scene, view, Deadline::max()));
    int calls = 0, callsToPreview = 0, areas = 0, lit = 0, hidden = 0;
    for (bool isComplete = false; !isComplete; ++calls) {
        isComplete = sliced.advance(scene, view, Deadline::min());
        if (callsToPreview > 0 || !sliced.hasPreview()) continue;
        callsToPreview = calls + 1;
        EXPECT_FALSE(isComplete);
        for (int light = 0; light < lights; ++light) {
            if (!scene::hasArea(scene->light(light))) continue;
            ++areas;
            ASSERT_TRUE(sliced.isPreview(light));
            for (const PixelLight::Share& share : sliced.sharesFromBelow(light)) {
                ASSERT_TRUE(share.seen == 0 || share.seen == 1) << "a point is seen, or not";
                lit += share.seen == 1;
                hidden += share.seen == 0;
            }
        }
    }
    EXPECT_GE(areas, 2);
    EXPECT_GT(lit, 5000);
    EXPECT_GT(hidden, 1000);
    EXPECT_GT(calls, callsToPreview + 10) << "the shares are the larger part of the work";
    for (int light = 0; light < lights; ++light) {
        EXPECT_FALSE(sliced.isPreview(light));
        const auto &expected = whole.sharesFromBelow(light), &found = sliced.sharesFromBelow(light);
        ASSERT_EQ(found.size(), expected.size());
        for (std::size_t i = 0; i < found.size(); ++i) {
            ASSERT_EQ(found[i].seen, expected[i].seen);
            ASSERT_EQ(found[i].irradiance, expected[i].irradiance);
        }
    }
}

// What was found for another eye is no preview.
TEST(PixelLightPreviewTest, AnotherEyeBeginsAnew) {
    const scene::Snapshot scene = roomWithLamps();
    View view = viewOf(scene);
    PixelLight light;
    ASSERT_TRUE(light.advance(scene, view, Deadline::max()));
    EXPECT_TRUE(light.hasPreview());
    view.camera.positionWorld.x += 0.1;
    EXPECT_FALSE(light.advance(scene, view, Deadline::min()));
    EXPECT_FALSE(light.hasPreview());
}

} // namespace
} // namespace shadowlab::radiosity
