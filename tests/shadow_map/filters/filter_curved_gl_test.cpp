// Wide kernels on what is curved: of a kernel's texels some belong to a part of the surface that slants otherwise, or to
// another surface altogether.
//   M9 a ball on a floor  NoPixelIsDarkenedAwayFromShadows
//                         naive: AConstantBiasDarkensSlopes, WithoutTheReceiversPlaneWideKernelsShadowThemselves
// SPDX-License-Identifier: MIT
#include <cmath>
#include <span>

#include <glm/gtc/constants.hpp>

#include "techniques/foundation/scene/model/shapes.h"
#include "tests/shadow_map/edge_reach.h"
#include "tests/support/gl_fixture.h"
#include "tests/support/light_shares.h"
#include "tests/support/scenes.h"

namespace shadowlab {
namespace {

using testing::JudgedPicture;
using testing::TieRadius;
using FilterCurvedTest = testing::GlTest;

constexpr ivec2 kSize{256, 192};
constexpr int kResolution = 512;
constexpr std::uint32_t kFloor = 0;

/// A ball of one metre on the floor, which it touches, under a light from the side and from above.
scene::Snapshot ballOnFloor(const scene::Light& light) {
    scene::Scene scene = testing::floorScene();
    testing::addObject(scene, scene::makeSphere(1, 64), testing::translation({0, 1, 0}));
    scene.camera.positionWorld = {0, 2.5, 4};
    scene.camera.targetWorld = {0, 0.8, 0};
    scene.lights.push_back(light);
    return testing::snapshot(scene);
}

scene::Light lamp() { return testing::pointLight({3, 4, 2}); }
scene::Light sun() { return testing::directionalLight({-0.6, -0.7, -0.4}); }
scene::Light largeLamp() {
    scene::Light light = lamp();
    light.name = "large lamp";
    light.type = scene::LightType::sphere;
    light.radius = 0.25;
    return light;
}

/// Metres on a surface, at right angles to the light, as pixels; as edgeReach does it for texels.
TieRadius metresReach(const scene::Snapshot& snapshot, double metres) {
    return [=](const std::optional<trace::EyeHit>& hit) {
        if (!hit) return 1.5;
        const scene::Light& light = snapshot->lights[0];
        const bool parallel = light.type == scene::LightType::directional;
        const dvec3 toLight =
            parallel ? -light.directionWorld : glm::normalize(light.positionWorld - hit->positionWorld);
        const double onSurface = metres / std::max(0.02, std::abs(glm::dot(toLight, hit->geometricNormalWorld)));
        const double tanHalf = std::tan(snapshot->camera.fovYDegrees * glm::pi<double>() / 360.0);
        return std::max(1.5, onSurface * kSize.y / (2.0 * tanHalf * hit->distance));
    };
}

/// Of pixels that are lit in truth, and farther than the kernel reaches from where that ends.
struct Darkened {
    int onFloor = 0, onBall = 0; ///< how many there are
    int near = 0;                ///< not quite lit, but within the kernel's reach: left out
    int notQuiteLit = 0;         ///< by a thousandth at least: a single comparison of 1000
    int dark = 0;                ///< by half
};
std::ostream& operator<<(std::ostream& stream, const Darkened& d) {
    return stream << d.onFloor << " on the floor, " << d.onBall << " on the ball: " << d.notQuiteLit
                  << " not quite lit, " << d.dark << " of them dark; " << d.near << " within the kernel's reach";
}

Darkened darkened(const JudgedPicture& judged, testing::ShadowMapSlot& slot, std::vector<std::string> settings) {
    settings.push_back("resolution=" + std::to_string(kResolution));
    const judge::Grid<float> image = slot.shares(settings, kSize, 0);
    Darkened result;
    for (int y = 0; y < kSize.y; ++y)
        for (int x = 0; x < kSize.x; ++x) {
            if (judged.truth(x, y) != trace::Visibility::lit) continue;
            ++(judged.hit(x, y)->object == kFloor ? result.onFloor : result.onBall);
            if (image.at(x, y) > 0.999f) continue;
            if (judged.isTie(x, y)) {
                ++result.near;
                continue;
            }
            ++result.notQuiteLit;
            result.dark += image.at(x, y) < 0.5f;
        }
    EXPECT_GT(result.onFloor, 5000);
    EXPECT_GT(result.onBall, 3000);
    std::cout << judged.snapshot()->lights[0].name << " " << settings[0] << " " << settings[1] << ": " << result
              << "\n";
    return result;
}

// The corner of a square of (2 r + 1) x (2 r + 1) texels is (r + 1/2) sqrt(2) away.
const std::pair<std::vector<std::string>, double> kKernels[] = {{{"filter=pcf", "pcf-radius=2"}, 3.6},
                                                                {{"filter=pcf", "pcf-radius=4"}, 6.4},
                                                                {{"filter=disc", "disc-radius=2"}, 2.8},
                                                                {{"filter=disc", "disc-radius=8"}, 8.8}};

// M9. A ball lies behind each of its tangent planes, so nothing of it is nearer than the receiver's plane says, wherever the
// kernel looks; and beyond its outline the floor is farther still.
TEST_F(FilterCurvedTest, NoPixelIsDarkenedAwayFromShadows) {
    const auto expectLit = [](const JudgedPicture& judged, testing::ShadowMapSlot& slot,
                              const std::vector<std::string>& settings) {
        const Darkened d = darkened(judged, slot, settings);
        EXPECT_EQ(d.notQuiteLit, 0) << settings[0] << " " << settings[1] << ": " << d;
        EXPECT_LT(d.near, (d.onFloor + d.onBall) / 20) << "edges everywhere: the test says nothing";
    };
    for (const scene::Light& light : {lamp(), sun()}) {
        const auto snapshot = ballOnFloor(light);
        testing::ShadowMapSlot slot(snapshot);
        for (const auto& [settings, texels] : kKernels)
            expectLit({snapshot, kSize, 0, testing::edgeReach(snapshot, 0, kResolution, kSize, texels)}, slot,
                      settings);
    }
    // The penumbra reaches radius * (d_r - d_b) / d_b to each side, d_b being the distance of the ball's outline; PCSS takes
    // the mean, which for a half ball is 2/3 m nearer than its middle. The rays of the lamp, 4.7 m from that, end on the floor
    // at 8.7 m: 0.25 * (8.7 - 4.0) / 4.0 = 0.29 m. The sun's radius is that at a distance of one metre, and its rays go on
    // for 2.5 m behind the outline: 0.05 * (2.5 + 0.7) = 0.16 m.
    for (const auto& [light, reach] : {std::pair{largeLamp(), 0.29}, std::pair{sun(), 0.16}}) {
        const auto snapshot = ballOnFloor(light);
        testing::ShadowMapSlot slot(snapshot);
        expectLit({snapshot, kSize, 0, metresReach(snapshot, reach)}, slot, {"filter=pcss", "light-radius=0.05"});
    }
}

/// Under the lamp, with a square of 5 x 5 texels and with one of 9 x 9.
std::vector<Darkened> naive(const std::vector<std::string>& bias) {
    const auto snapshot = ballOnFloor(lamp());
    testing::ShadowMapSlot slot(snapshot);
    std::vector<Darkened> results;
    for (const auto& [settings, texels] : std::span(kKernels).first(2)) {
        std::vector<std::string> full = settings;
        full.insert(full.end(), bias.begin(), bias.end());
        results.push_back(
            darkened({snapshot, kSize, 0, testing::edgeReach(snapshot, 0, kResolution, kSize, texels)}, slot, full));
    }
    return results;
}

// Half a texel is what a slope of 45 degrees needs for a single comparison; the wider the kernel, the more it would be.
TEST_F(FilterCurvedTest, AConstantBiasDarkensSlopes) {
    for (const Darkened& d : naive({"bias-mode=constant", "constant-bias=0.5"})) {
        EXPECT_GT(d.notQuiteLit, 1000);
        EXPECT_GT(d.dark, 50);
    }
}

TEST_F(FilterCurvedTest, WithoutTheReceiversPlaneWideKernelsShadowThemselves) {
    for (const Darkened& d : naive({"slope-bias=0"})) {
        EXPECT_GT(d.notQuiteLit, 1000);
        EXPECT_GT(d.dark, 500);
    }
}

} // namespace
} // namespace shadowlab
