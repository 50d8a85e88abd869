// The stage `texel-size` against what follows from the light's matrix, on a floor seen from straight above.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include "app/lab/settings.h"
#include "app/report/measurement.h"
#include "techniques/foundation/gl/read_back.h"
#include "techniques/foundation/scene/model/shapes.h"
#include "tests/shadow_map/fit/scene_maps.h"
#include "tests/support/gl_fixture.h"
#include "tests/support/scenes.h"

namespace shadowlab {
namespace {

constexpr ivec2 kSize{240, 240};
constexpr double kEyeHeight = 8;

class TexelSizeTest : public testing::GlTest {
protected:
    /// A floor seen from straight above, and a box that casts a shadow on it; the sun comes from `fromWorld`. Only under
    /// the box there is a map to look into, so the box must not hide that place: it stands above the eye, or aside.
    static scene::Scene boxFromAbove(const dvec3& fromWorld, const dvec3& boxWorld = {0, 10, 0}) {
        scene::Scene scene = testing::floorScene();
        testing::addObject(scene, scene::makeBox({1, 0.2, 1}), testing::translation(boxWorld));
        scene.camera.positionWorld = {0, kEyeHeight, 0};
        scene.camera.targetWorld = {0, 0, 0};
        scene.camera.upWorld = {0, 0, -1};
        scene.camera.fovYDegrees = 40;
        scene.lights.push_back(testing::directionalLight(-fromWorld));
        return scene;
    }
    static std::vector<picture::Slot> slotWith(const std::vector<std::string>& settings) {
        std::vector<picture::Slot> slots;
        slots.push_back(picture::Session::makeSlot("shadow-map"));
        lab::applySettings(slots, settings);
        return slots;
    }
    /// Sizes on the floor, where the eye sees no caster and looks into the map.
    static std::vector<float> sizesOnFloor(const scene::Scene& scene, int resolution) {
        picture::Session session(testing::snapshot(scene));
        auto slots = slotWith({"shadow-map.resolution=" + std::to_string(resolution), "shadow-map.filter=hard"});
        View view;
        view.camera = scene.camera;
        view.size = kSize;
        FrameRequest request;
        request.stages = {{"texel-size", 0}};
        const picture::RenderedFrame rendered = session.render(slots[0], view, request);
        const std::vector<vec4> texels = gl::readTexels(picture::findStage(rendered, {"texel-size", 0}).texture);
        const judge::Truth& truth = session.truth(view, 0);
        std::vector<float> sizes;
        for (std::size_t i = 0; i < texels.size(); ++i) {
            EXPECT_TRUE(std::isfinite(texels[i].r));
            if (texels[i].g > 0.5f && truth.objects[i] == 0) sizes.push_back(texels[i].r);
        }
        std::ranges::sort(sizes);
        return sizes;
    }
};

TEST_F(TexelSizeTest, OfASunFromAboveIsTheMapsExtentOverItsResolution) {
    const scene::Scene scene = boxFromAbove({0, 1, 0});
    for (const int resolution : {64, 128}) {
        const std::vector<float> sizes = sizesOnFloor(scene, resolution);
        ASSERT_GT(sizes.size(), 300u);
        const shadow_map::LightMaps maps = testing::sceneMaps(scene, scene.lights[0], resolution, 0);
        const dmat4 clip = maps.lightClipFromLightRelative(0);
        // A metre along x, and along z, in texels; from above both are at right angles in the map.
        const double alongX = glm::length(dvec2(clip[0])) * 0.5 * resolution;
        const double alongZ = glm::length(dvec2(clip[2])) * 0.5 * resolution;
        const double pixelsPerMetre = 0.5 * kSize.y / (kEyeHeight * std::tan(20 * M_PI / 180));
        const double expected = pixelsPerMetre / std::min(alongX, alongZ);
        // The picture is flat and parallel: every pixel has the same size, up to float derivatives (2^-20 of 8 m, over
        // steps of a fortieth of a metre).
        EXPECT_NEAR(sizes.front(), expected, 0.01 * expected);
        EXPECT_NEAR(sizes.back(), expected, 0.01 * expected);
    }
}

TEST_F(TexelSizeTest, HalfTheResolutionIsTwiceTheSizeAndGrazingLightMakesItLonger) {
    const auto median = [](const std::vector<float>& sizes) { return sizes.at(sizes.size() / 2); };
    const scene::Scene above = boxFromAbove({0, 1, 0});
    EXPECT_NEAR(median(sizesOnFloor(above, 128)), 2 * median(sizesOnFloor(above, 256)),
                0.05f * median(sizesOnFloor(above, 128)));
    // Light at an angle of 14 degrees to the floor stretches what it projects by 1 / sin 14 = 4.1. The map is a little
    // smaller for the box seen from its side.
    EXPECT_GT(median(sizesOnFloor(boxFromAbove({1, 0.25, 0}, {1.5, 0.7, 0}), 256)),
              2 * median(sizesOnFloor(above, 256)));
}

// Inside the reach of a texel an error is aliasing; acne is everywhere, and stays an error of the core.
TEST_F(TexelSizeTest, TellsAliasingFromAcne) {
    const auto snapshot = testing::snapshot(testing::simpleScene());
    const auto measured = [&](const std::vector<std::string>& settings) {
        picture::Session session(snapshot);
        auto slots = slotWith(settings);
        report::Measurement measurement(session, slots, 0, {320, 240});
        measurement.addFrame({snapshot, snapshot->camera});
        return measurement.results()[0];
    };
    const auto coarse = measured({"shadow-map.resolution=64"});
    EXPECT_GT(coarse.counts.wrong(), 50);
    EXPECT_LT(coarse.coreErrors, coarse.counts.wrong() / 5);
    const auto acne = measured({"shadow-map.bias-mode=none", "shadow-map.filter=hard"});
    EXPECT_GT(acne.coreErrors, 1000);
}

} // namespace
} // namespace shadowlab
