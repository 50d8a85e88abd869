// The lecture's radiosity as it is drawn: rooms whose radiosity is known, and how coarse its shadows are.
// SPDX-License-Identifier: MIT
#include "app/context/assets.h"
#include "app/lab/settings.h"
#include "techniques/foundation/gl/read_back.h"
#include "techniques/foundation/scene/load/load.h"
#include "tests/radiosity/scene_room.h"
#include "tests/support/gl_fixture.h"
#include "tests/support/truth_comparison.h"

namespace shadowlab {
namespace {

using LectureRadiosityTest = testing::GlTest;

std::vector<vec4> texelsOf(const scene::Snapshot& snapshot, const std::vector<std::string>& settings,
                           const std::string& technique = "lecture-radiosity", ivec2 size = {64, 48}) {
    picture::Session session(snapshot);
    std::vector<picture::Slot> slots;
    slots.push_back(picture::Session::makeSlot(technique));
    std::vector<std::string> full;
    for (const std::string& setting : settings)
        full.push_back(technique + "." + setting);
    lab::applySettings(slots, full);
    View view;
    view.camera = snapshot->camera;
    view.size = size;
    EXPECT_TRUE(session.render(slots[0], view).converged);
    return gl::readTexels(slots[0].target.color);
}

scene::Snapshot uniformRoom(float emission, float reflectance) {
    scene::Scene scene = testing::emptyRoom({3, 2, 4});
    scene.materials[0].emission = vec3(emission);
    scene.materials[0].diffuse = vec3(reflectance);
    scene.camera.positionWorld = {0.3, 1.2, 3.6};
    scene.camera.targetWorld = {2, 0.7, 0};
    scene.camera.fovYDegrees = 80;
    return testing::snapshot(scene);
}

double meanGreen(const std::vector<vec4>& texels) {
    double sum = 0;
    for (const vec4& texel : texels)
        sum += texel.g;
    return sum / static_cast<double>(texels.size());
}

// The furnace: in a room whose walls all emit E and reflect rho, everything has B = E / (1 - rho). After k repetitions it is
// E (1 + rho + ... + rho^k).
TEST_F(LectureRadiosityTest, InAFurnaceEveryRepetitionAddsOneReflection) {
    constexpr double kE = 0.25, kRho = 0.5;
    double expected = 0;
    for (int bounces = 0; bounces <= 4; ++bounces) {
        expected += kE * std::pow(kRho, bounces);
        const auto texels = texelsOf(uniformRoom(kE, kRho), {"patches=600", "bounces=" + std::to_string(bounces)});
        // Rows sum to 1 within a hundredth on average, and each reflection is wrong by as much.
        EXPECT_NEAR(meanGreen(texels), expected, bounces == 0 ? 1e-3 : 0.01 * expected) << bounces;
    }
    const auto texels = texelsOf(uniformRoom(kE, kRho), {"patches=600", "bounces=30"});
    ASSERT_GT(texels.size(), 3000u);
    for (const vec4& texel : texels)
        ASSERT_NEAR(texel.g, kE / (1 - kRho), 0.05 * kE / (1 - kRho)); // in corners rows are wrong by up to a twentieth
}

// A floor that sees nothing but the background reflects rho of it: the row sum is 0, and the wall that encloses it is the background.
TEST_F(LectureRadiosityTest, WhatSeesNoSurfaceSeesTheBackground) {
    scene::Scene scene = testing::floorScene();
    scene.background = {0.5f, 0.25f, 0.125f};
    scene.materials[0].diffuse = vec3(0.5f);
    scene.camera.positionWorld = {0, 2, 0.1}; // only the floor is in view
    const auto texels = texelsOf(testing::snapshot(scene), {});
    int compared = 0;
    for (const vec4& texel : texels) {
        ASSERT_NEAR(texel.r, 0.25, 1e-3); // half floats
        ASSERT_NEAR(texel.g, 0.125, 1e-3);
        ++compared;
    }
    EXPECT_GT(compared, 3000);
}

// The production technique finds form factors in closed form, and direct light at its own points; flat patches are shown by both. Their
// patches differ in shape and size, so pixels differ at borders; the light in the room may not.
TEST_F(LectureRadiosityTest, TheRoomIsAsBrightAsByTheProductionTechnique) {
    for (const char* name : {"cornell-room", "room-with-lamps"}) {
        const scene::Snapshot room =
            scene::loadScene(name, {.assetsRoot = context::assetsRoot(), .allowed = {}, .limits = {}});
        const auto mine = texelsOf(room, {}, "lecture-radiosity", {320, 180});
        const auto theirs = texelsOf(room, {"patches=1200", "display=flat"}, "radiosity", {320, 180});
        double difference = 0;
        for (std::size_t i = 0; i < mine.size(); ++i)
            difference += std::abs(mine[i].g - theirs[i].g);
        difference /= static_cast<double>(mine.size());
        std::cout << name << ": mean " << meanGreen(mine) << " against " << meanGreen(theirs) << ", mean difference "
                  << difference << "\n";
        EXPECT_GT(meanGreen(theirs), 0.05);
        EXPECT_NEAR(meanGreen(mine), meanGreen(theirs), 0.03 * meanGreen(theirs));
        EXPECT_LT(difference, 0.1 * meanGreen(theirs));
    }
}

// Its shadows are as coarse as its patches: with smaller ones they are wrong in fewer pixels.
TEST_F(LectureRadiosityTest, ShadowsAreAsCoarseAsPatches) {
    const scene::Snapshot room =
        scene::loadScene("cornell-room", {.assetsRoot = context::assetsRoot(), .allowed = {}, .limits = {}});
    const testing::JudgedPicture truth(room, {320, 180}, 0, testing::kTiePx);
    std::vector<int> wrong;
    for (const char* patches : {"patches=100", "patches=400", "patches=1600"})
        wrong.push_back(
            truth.differing(testing::renderVisibility(room, "lecture-radiosity", {patches}, {320, 180}, 0)));
    std::cout << "wrong pixels: " << wrong[0] << ", " << wrong[1] << ", " << wrong[2] << "\n";
    EXPECT_GT(wrong[2], 50) << "a patch has one visibility: some pixels must be wrong";
    EXPECT_LT(wrong[1], 0.8 * wrong[0]);
    EXPECT_LT(wrong[2], 0.8 * wrong[1]);
}

} // namespace
} // namespace shadowlab
