// What pixels should show without shadows, where an object emits light on its front alone.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <chrono>

#include "app/foreign/expected_light.h"
#include "techniques/foundation/scene/load/load.h"
#include "tests/foundation/scene/scene_files.h"

namespace shadowlab::foreign {
namespace {

/// A panel that faces upward and emits 0.5 there, seen by the eye at that height. `scale`: of the panel.
ExpectedLight ofPanel(const std::string& scale, double eyeHeight) {
    const scene::TempFolder folder;
    const auto file = folder.write("panel.json", R"({"camera": {"position": [0, )" + std::to_string(eyeHeight) + R"(, 0.5], "target": [0, 0, 0]},
        "ambient": [0, 0, 0], "lights": [{"name": "key", "type": "point", "position": [0, 0, 9], "intensity": 0}],
        "materials": {"panel": {"diffuse": [0.8, 0.8, 0.8], "emission": [0.5, 0.5, 0.5], "emits": "front"}},
        "objects": [{"name": "panel", "shape": "quad", "size": [4, 4], "scale": )" + scale + R"(, "material": "panel"}]})");
    const scene::Snapshot scene = scene::loadScene(file.string(), {});
    trace::SceneTracer tracer;
    tracer.advance(scene, std::chrono::steady_clock::time_point::max());
    return expectedLight(tracer, scene->camera, {3, 3}, 0);
}

// A mirrored object is wound the other way in the world, but its front is where it was.
TEST(ExpectedLightTest, AMirroredPanelEmitsOnItsFront) {
    constexpr std::size_t kMiddle = 4;
    int cases = 0;
    for (const char* const scale : {"[1, 1, 1]", "[-1, 1, 1]", "[1, 1, -1]"}) {
        EXPECT_FLOAT_EQ(ofPanel(scale, 2).remaining[kMiddle].g, 0.5f) << scale;
        EXPECT_FLOAT_EQ(ofPanel(scale, -2).remaining[kMiddle].g, 0.0f) << scale;
        ++cases;
    }
    EXPECT_EQ(cases, 3);
}

} // namespace
} // namespace shadowlab::foreign
