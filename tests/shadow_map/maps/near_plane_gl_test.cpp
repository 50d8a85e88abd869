// Under a roof that is nearer to the light than the map's near plane everything is dark, also what light would graze: its plane
// seems to reach before the near plane, too.
//   no light        ARoofBeforeTheNearPlaneKeepsGrazedWallsDark; naive: reference_before_near
//   no more shadow  WhereNothingIsBeforeTheNearPlaneNothingChanges
//   the probe       TheProbeComparesAsThePictureDoes
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <iostream>

#include <glm/gtc/matrix_transform.hpp>

#include "techniques/foundation/scene/model/shapes.h"
#include "techniques/probed/map_probe.h"
#include "tests/support/gl_fixture.h"
#include "tests/support/light_shares.h"
#include "tests/support/other_shaders.h"
#include "tests/support/probed_picture.h"
#include "tests/support/scenes.h"

namespace shadowlab {
namespace {

using testing::LightShares;
using testing::OtherShaders;
using testing::ShadowMapSlot;
using NearPlaneTest = testing::GlTest;

constexpr ivec2 kSize{160, 120};
const dvec3 kLampWorld(0.5, 4, 0.25);

enum class Lit { byLamp, bySun };

/// Walls that the light grazes on the side that the eye sees: their planes pass it by a hair, a centimetre and a decimetre.
scene::Scene walls(Lit lit) {
    scene::Scene scene = testing::floorScene();
    scene.lights = {lit == Lit::byLamp ? testing::pointLight(kLampWorld) : testing::directionalLight({0, -1, 0})};
    constexpr double kThick = 0.1;
    double z = -1.2;
    for (const double off : {1e-4, 1e-2, 0.1}) {
        // Under a sun the wall is turned as far as the lamp would be off its plane; it faces +x, and the light stands on that side.
        const dmat4 leaning =
            lit == Lit::bySun ? glm::rotate(dmat4(1.0), off / kLampWorld.y, dvec3(0, 0, 1)) : dmat4(1.0);
        const double x = (lit == Lit::byLamp ? kLampWorld.x - off : 0.0) - 0.5 * kThick;
        testing::addObject(scene, scene::makeBox({kThick, 1, 0.7}), testing::translation({x, 0.6, z}) * leaning);
        z += 1;
    }
    scene.camera.positionWorld = {3, 1.5, 0.2};
    scene.camera.targetWorld = {0.3, 0.5, -0.2};
    scene.camera.fovYDegrees = 50;
    return scene;
}

/// With a box around the lamp, or a roof above all that the eye sees.
scene::Snapshot roofed(Lit lit) {
    scene::Scene scene = walls(lit);
    if (lit == Lit::byLamp)
        testing::addObject(scene, scene::makeBox({0.5, 0.5, 0.5}), testing::translation(kLampWorld));
    else
        testing::addObject(scene, scene::makeBox({40, 0.1, 40}), testing::translation({0, 6, 0}));
    return testing::snapshot(scene);
}

struct Count {
    int surfaces = 0, lit = 0;
    explicit Count(const LightShares& shares) {
        for (const float share : shares.values) {
            surfaces += share != testing::kNoShare;
            lit += share != testing::kNoShare && share != 0;
        }
    }
};

const std::vector<std::vector<std::string>> kFilters = {
    {"filter=hard"}, {"filter=hw2x2"}, {"filter=pcf", "pcf-radius=2"}, {"filter=disc", "disc-radius=3"}};

TEST_F(NearPlaneTest, ARoofBeforeTheNearPlaneKeepsGrazedWallsDark) {
    int compared = 0, litNaively = 0;
    for (const Lit lit : {Lit::byLamp, Lit::bySun}) {
        ShadowMapSlot slot(roofed(lit)), naive(roofed(lit));
        for (const std::vector<std::string>& kind :
             std::vector<std::vector<std::string>>{{"bias-mode=receiver-plane"},
                                                   {"bias-mode=receiver-plane", "depth-format=16"},
                                                   {"bias-mode=receiver-plane", "depth-format=32f"},
                                                   {"bias-mode=adaptive"},
                                                   {"bias-mode=slope-scaled"},
                                                   {"bias-mode=normal-offset"},
                                                   {"bias-mode=dual-depth"}})
            for (std::vector<std::string> settings : kFilters) {
                settings.insert(settings.end(), kind.begin(), kind.end());
                settings.emplace_back("resolution=512");
                const Count count(slot.shares(settings, kSize));
                EXPECT_EQ(count.lit, 0) << kind[0] << ", " << kind.back() << ", " << settings[0];
                EXPECT_GT(count.surfaces, 5000);
                compared += count.surfaces;
                const OtherShaders before("shadow_map/reference_before_near");
                litNaively += Count(naive.shares(settings, kSize)).lit;
            }
    }
    std::cout << compared << " pixels dark, of which naively " << litNaively << " have light\n";
    EXPECT_GT(litNaively, 1000);
}

TEST_F(NearPlaneTest, WhereNothingIsBeforeTheNearPlaneNothingChanges) {
    int lit = 0, shadowed = 0;
    for (const Lit light : {Lit::byLamp, Lit::bySun}) {
        const auto scene = testing::snapshot(walls(light));
        ShadowMapSlot slot(scene), naive(scene);
        for (const std::vector<std::string>& settings : kFilters) {
            const LightShares shares = slot.shares(settings, kSize);
            const OtherShaders before("shadow_map/reference_before_near");
            EXPECT_EQ(shares.values, naive.shares(settings, kSize).values) << settings[0];
            lit += static_cast<int>(std::ranges::count(shares.values, 1.0f));
            shadowed += static_cast<int>(std::ranges::count(shares.values, 0.0f));
        }
    }
    EXPECT_GT(lit, 20000);
    EXPECT_GT(shadowed, 2000);
}

TEST_F(NearPlaneTest, TheProbeComparesAsThePictureDoes) {
    for (const Lit lit : {Lit::byLamp, Lit::bySun}) {
        testing::ProbedPicture picture(roofed(lit), "shadow-map", {"filter=hard", "resolution=512"}, kSize);
        int compared = 0, raised = 0;
        for (int y = 1; y < kSize.y; y += 4)
            for (int x = 1; x < kSize.x; x += 4) {
                const Probe probe = picture.probe(x, y);
                if (!probe.find<MapProbe>()) continue;
                EXPECT_GT(probe.find<MapProbe>()->compared, probe.find<MapProbe>()->stored) << x << ", " << y;
                ++compared;
                raised += probe.find<MapProbe>()->compared < 1e-4; // no point is so near to the near plane
            }
        EXPECT_GT(compared, 300);
        EXPECT_GT(raised, 10);
    }
}

} // namespace
} // namespace shadowlab
