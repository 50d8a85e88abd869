// Whole scenes against the exact judge: every built-in one, and any that SHADOWLAB_TRUTH_SCENES names (paths separated
// by colons: .json or .obj), each from its own camera and from others around it.
// SPDX-License-Identifier: MIT
#include <sstream>

#include "app/context/assets.h"
#include "app/film/orbit.h"
#include "techniques/foundation/scene/load/load.h"
#include "tests/shadow_map/edge_reach.h"
#include "tests/support/gl_fixture.h"
#include "tests/support/perforated.h"
#include "tests/support/truth_comparison.h"

namespace shadowlab {
namespace {

using testing::compareWithTruth;
using testing::TruthComparison;
using TruthOfScenes = testing::GlTest;

// See zfail_gl_test.cpp: what is left are isolated pixels at cracks.
constexpr double kCrackShare = 3e-5;

TruthComparison zfailFromAround(const scene::Snapshot& base, ivec2 size, int views) {
    TruthComparison sum;
    for (int v = 0; v < views; ++v) {
        auto scene = std::make_shared<scene::Scene>(*base);
        scene->camera = film::turned(base->camera, 360.0 * v / views);
        for (int light = 0; light < static_cast<int>(base->lights.size()); ++light)
            sum += compareWithTruth(scene, "shadow-volume-zfail", {}, size, light, testing::kTiePx);
    }
    return sum;
}

TEST_F(TruthOfScenes, ZFailIsExactInEveryBuiltInScene) {
    const auto root = context::assetsRoot();
    int scenes = 0;
    TruthComparison all;
    for (const std::string& name : scene::builtInScenes(root)) {
        const scene::Snapshot snapshot = scene::loadScene(name, {.assetsRoot = root, .allowed = {}, .limits = {}});
        if (testing::castsThroughHoles(*snapshot)) continue; // see holes_gl_test.cpp
        const TruthComparison sum = zfailFromAround(snapshot, {160, 90}, std::getenv("SHADOWLAB_LONG") ? 8 : 1);
        std::cout << name << ": " << sum << "\n";
        EXPECT_GT(sum.lit, 500) << name;
        EXPECT_GT(sum.shadowed, 500) << name;
        all += sum;
        ++scenes;
    }
    EXPECT_GE(scenes, 9);
    EXPECT_LE(all.wrong(), kCrackShare * all.compared) << all;
}

// As it comes: the default filter and resolution. `core` errors would mean a wrong algorithm, not a coarse map.
TEST_F(TruthOfScenes, TheShadowMapIsWrongOnlyNearEdgesInEveryBuiltInScene) {
    const auto root = context::assetsRoot();
    const ivec2 size{240, 135};
    for (const std::string& name : scene::builtInScenes(root)) {
        const scene::Snapshot snapshot = scene::loadScene(name, {.assetsRoot = root, .allowed = {}, .limits = {}});
        for (int light = 0; light < static_cast<int>(snapshot->lights.size()); ++light) {
            const TruthComparison sum = compareWithTruth(snapshot, "shadow-map", {}, size, light,
                                                         testing::edgeReach(snapshot, light, 2048, size, 1.5));
            std::cout << name << "@" << snapshot->light(light).name << ": " << sum << "\n";
            EXPECT_GT(sum.lit, 500) << name;
            EXPECT_GT(sum.shadowed, 50) << name; // a lamp near the camera hides its shadows behind what casts them
            EXPECT_EQ(sum.wrong(), 0) << name;
        }
    }
}

TEST_F(TruthOfScenes, BothHoldInScenesGivenByTheUser) {
    const char* given = std::getenv("SHADOWLAB_TRUTH_SCENES");
    if (!given) GTEST_SKIP() << "SHADOWLAB_TRUTH_SCENES names no scenes";
    std::istringstream paths(given);
    std::string path;
    TruthComparison all;
    while (std::getline(paths, path, ':')) {
        const scene::Snapshot staged =
            scene::loadScene(path, {.assetsRoot = context::assetsRoot(), .allowed = {}, .limits = {}});
        auto scene = std::make_shared<scene::Scene>(*staged);
        scene::Light sun;
        sun.name = "sun";
        sun.type = scene::LightType::directional;
        sun.directionWorld = glm::normalize(dvec3(0.6, -0.7, -0.4));
        scene->lights.push_back(sun);
        const TruthComparison sum = zfailFromAround(scene, {320, 240}, 5);
        std::cout << path << ": " << sum << "\n";
        EXPECT_GT(sum.shadowed, 500) << path;
        all += sum;
        for (int light = 0; light < 2; ++light) {
            const TruthComparison map = compareWithTruth(scene, "shadow-map", {}, {320, 240}, light,
                                                         testing::edgeReach(scene, light, 2048, {320, 240}, 1.5));
            std::cout << path << ", shadow map: " << map << "\n";
            EXPECT_EQ(map.wrong(), 0) << path;
        }
    }
    std::cout << "all: " << all << "\n";
    EXPECT_LE(all.wrong(), kCrackShare * all.compared) << all;
}

} // namespace
} // namespace shadowlab
