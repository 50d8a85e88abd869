// Maps do not depend on the unit of length that a scene is written in, though their ranges are rounded.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "tests/shadow_map/fit/scene_maps.h"
#include "tests/support/scenes.h"

namespace shadowlab::shadow_map {
namespace {

TEST(FitScale, AScaledSceneHasTheSameMapsScaled) {
    scene::Scene scene = testing::simpleScene();
    scene.lights = {testing::directionalLight({0.5, -1, 0.25}), testing::pointLight({2, 5, 3}),
                    testing::pointLight({0, 1.2, 0.1})};
    const ProjectionParams params{
        .fit = ProjectionParams::Fit::scene, .cascades = 4, .depthBounds = ProjectionParams::DepthBounds::camera};
    for (const double factor : {1e-4, 1e-3, 3.0, 1e4}) {
        const scene::Scene large = testing::scaled(scene, factor);
        for (std::size_t light = 0; light < scene.lights.size(); ++light) {
            const LightMaps here = testing::sceneMaps(scene, scene.lights[light], 512, 1, params);
            const LightMaps there = testing::sceneMaps(large, large.lights[light], 512, 1, params);
            ASSERT_GT(here.layers(), 0);
            ASSERT_EQ(here.layers(), there.layers());
            EXPECT_NEAR(there.nearest, factor * here.nearest, 1e-9 * factor);
            EXPECT_NEAR(there.farthest, factor * here.farthest, 1e-9 * factor);
            ASSERT_EQ(here.cascadeEnds.size(), there.cascadeEnds.size());
            for (std::size_t i = 0; i < here.cascadeEnds.size(); ++i)
                EXPECT_NEAR(there.cascadeEnds[i], factor * here.cascadeEnds[i], 1e-9 * factor);
            // The same place in the map, in texels and depth.
            const dvec3 point(0.5, 0.25, -0.75);
            for (int layer = 0; layer < here.layers(); ++layer) {
                const dvec4 a = here.lightClipFromLightRelative(layer) * dvec4(point, 1);
                const dvec4 b = there.lightClipFromLightRelative(layer) * dvec4(factor * point, 1);
                EXPECT_LT(glm::length(dvec3(a) / a.w - dvec3(b) / b.w), 1e-9) << factor << ", layer " << layer;
            }
        }
    }
}

} // namespace
} // namespace shadowlab::shadow_map
