// The bound on overlapping volumes is one, and a close one.
// SPDX-License-Identifier: MIT
#include "techniques/shadow_volume/cull/overlaps.h"

#include <gtest/gtest.h>

#include "app/context/assets.h"
#include "techniques/foundation/scene/load/load.h"
#include "techniques/foundation/scene/model/shapes.h"
#include "techniques/foundation/trace/judge/exact_visibility.h"
#include "tests/support/hard_scenes.h"
#include "tests/support/scenes.h"

namespace shadowlab {
namespace {

int boundOf(const scene::Scene& scene, int light = 0) {
    shadow_volume::Casters casters;
    const scene::Snapshot snapshot = testing::snapshot(scene);
    while (!casters.buildNext(snapshot)) {
    }
    return casters.overlaps(light);
}

/// Of the points that a coarse picture shows: the most triangles between one and the light.
int mostSeen(const scene::Scene& scene) {
    const trace::ExactVisibility exact(testing::snapshot(scene));
    constexpr ivec2 kSize{24, 18};
    int most = 0;
    for (int y = 0; y < kSize.y; ++y)
        for (int x = 0; x < kSize.x; ++x)
            if (const auto hit = exact.eyeHit(scene.camera, dvec2(x, y) + 0.5, kSize))
                most = std::max(most, exact.crossings(*hit, 0));
    return most;
}

TEST(OverlapBound, OfStackedSheetsIsTheirNumber) {
    for (const bool sun : {false, true})
        for (const int count : {1, 7, 256}) {
            scene::Scene scene = testing::floorScene();
            for (scene::Object& object : scene.objects)
                object.castsShadow = false;
            for (int i = 0; i < count; ++i)
                testing::addObject(scene, testing::triangleSoup(
                                              {{-1, 1 + 0.01 * i, -1}, {-1, 1 + 0.01 * i, 1}, {1, 1 + 0.01 * i, 1}}));
            scene.lights = {sun ? testing::directionalLight({0, -1, 0}) : testing::pointLight({3, 10, 0})};
            EXPECT_EQ(boundOf(scene), count) << (sun ? "sun" : "lamp");
        }
}

// Of closed parts only front faces are counted, so the count may be below the number of triangles, never above the bound.
TEST(OverlapBound, IsNoLessThanWhatHardScenesHave) {
    long above = 0, seen = 0;
    for (const bool directional : {false, true})
        for (const testing::HardClass hardClass : testing::kHardClasses)
            for (unsigned i = 0; i < 6; ++i) {
                const scene::Scene scene = testing::hardScene(hardClass, i, directional);
                const int bound = boundOf(scene), most = mostSeen(scene);
                // Every crossing counts in soups; a solid is crossed twice and counted once.
                if (hardClass == testing::HardClass::soup || hardClass == testing::HardClass::eyeInSoup)
                    EXPECT_GE(bound, most) << toText(hardClass) << " scene " << i;
                else
                    EXPECT_GE(2 * bound, most) << toText(hardClass) << " scene " << i;
                above += bound > most;
                seen += most;
            }
    EXPECT_GT(seen, 72) << "at least one on average";
    EXPECT_GT(above, 0);
}

TEST(OverlapBound, OfTheBuiltInScenesLetsTheStencilCount) {
    const scene::LoadOptions options{.assetsRoot = context::assetsRoot(), .allowed = {}, .limits = {}};
    for (const std::string& name : scene::builtInScenes(options.assetsRoot)) {
        const scene::Scene scene = *scene::loadScene(name, options);
        for (std::size_t light = 0; light < scene.lights.size(); ++light) {
            const int bound = boundOf(scene, static_cast<int>(light));
            std::cout << name << ", light " << light << ": at most " << bound << "\n";
            EXPECT_LE(bound, 255) << name;
            EXPECT_GE(bound, 1) << name;
        }
    }
}

} // namespace
} // namespace shadowlab
