// The direct light of each pixel, held against closed forms, the exact judge, and ray tracing.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <chrono>
#include <cmath>

#include <glm/gtc/constants.hpp>

#include "app/context/assets.h"
#include "techniques/foundation/scene/load/load.h"
#include "tests/radiosity/scene_room.h"
#include "tests/support/gl_fixture.h"
#include "tests/support/light_shares.h"
#include "tests/support/truth_comparison.h"

namespace shadowlab {
namespace {

using RadiosityPixelLightTest = testing::GlTest;

constexpr ivec2 kSize{160, 90};

scene::Snapshot builtIn(const char* name) {
    return scene::loadScene(name, {.assetsRoot = context::assetsRoot(), .allowed = {}, .limits = {}});
}

// Patches as large as walls, so that all that is right is so by the pixels' own rays.
const std::string kFewPatches = "patches=100";

// A lamp, a sun and a spot: as ray tracing, radiosity has no wrong pixel outside ties, however large its patches are.
TEST_F(RadiosityPixelLightTest, HardShadowsHaveNoWrongPixel) {
    int byPatches = 0;
    for (const char* name : {"still-life", "colonnade", "three-lights"}) {
        const scene::Snapshot scene = builtIn(name);
        for (int light = 0; light < static_cast<int>(scene->lights.size()); ++light) {
            if (scene::hasArea(scene->light(light))) continue;
            const ivec2 size = kSize / 2; // the judge tries all triangles for each pixel, up to 54,250
            const testing::JudgedPicture judged(scene, size, light, testing::kTiePx);
            const testing::TruthComparison pixels =
                judged.compare(testing::renderVisibility(scene, "radiosity", {kFewPatches}, size, light));
            EXPECT_EQ(pixels.wrong(), 0) << name << ", light " << light << ": " << pixels;
            EXPECT_GT(pixels.lit, 800) << name;
            EXPECT_GT(pixels.shadowed, 50) << name;
            if (name == std::string("colonnade")) continue; // its meshes are simplified anew for each picture: seconds
            const std::vector<std::string> patches{kFewPatches, "direct=patches"};
            byPatches += judged.differing(testing::renderVisibility(scene, "radiosity", patches, size, light));
        }
    }
    EXPECT_GT(byPatches, 300) << "patches alone know of no edge";
}

// Of a light with an area, both find the share that is seen in closed form.
TEST_F(RadiosityPixelLightTest, SoftShadowsAreThoseOfRayTracing) {
    const scene::Snapshot scene = builtIn("cornell-room");
    ASSERT_TRUE(scene::hasArea(scene->light(0)));
    const testing::LightShares rays =
        testing::TechniqueSlot("ray-traced", scene).shares({"soft-shadows=analytic", "antialias=false"}, kSize);
    testing::TechniqueSlot radiosity("radiosity", scene);
    const testing::LightShares pixels = radiosity.shares({kFewPatches}, kSize),
                               patches = radiosity.shares({kFewPatches, "direct=patches"}, kSize);
    int compared = 0, penumbra = 0, wrong = 0, wrongByPatches = 0;
    for (std::size_t i = 0; i < rays.values.size(); ++i) {
        if (rays.values[i] < 0 || pixels.values[i] < 0) continue;
        ++compared;
        penumbra += rays.values[i] > 0.01f && rays.values[i] < 0.99f;
        // The same function in the same doubles; only at edges of the blocks may rasteriser and rays show different surfaces.
        wrong += std::abs(rays.values[i] - pixels.values[i]) > 1e-6f;
        wrongByPatches += std::abs(rays.values[i] - patches.values[i]) > 0.05f;
    }
    EXPECT_GT(compared, 8000);
    EXPECT_GT(penumbra, 500);
    EXPECT_LE(wrong, 3) << "ties at silhouettes";
    EXPECT_GT(wrongByPatches, 500);
}

// Before a black background one plane reflects nothing that comes back: rho / pi I cos / d^2 at each pixel, and nothing else.
TEST_F(RadiosityPixelLightTest, APlaneUnderALampIsItsClosedForm) {
    scene::Scene scene;
    scene.materials.emplace_back();
    scene.materials[0].diffuse = vec3(0.6f, 0.3f, 0.9f);
    testing::addObject(scene, scene::makeQuad({16, 16}), dmat4(1));
    scene.lights.push_back(testing::pointLight({0.5, 2, -0.3}));
    scene.lights[0].intensity = 5;
    scene.camera.positionWorld = {0, 6, 0.01};
    scene.camera.targetWorld = {0, 0, 0};
    scene.camera.fovYDegrees = 50;
    const scene::Snapshot snapshot = testing::snapshot(scene);
    const auto worst = [&](const std::string& direct) {
        const std::vector<vec4> texels =
            testing::TechniqueSlot("radiosity", snapshot).radiance({kFewPatches, direct, "surroundings=dark"}, kSize);
        double worst = 0;
        int compared = 0;
        for (int y = 0; y < kSize.y; ++y)
            for (int x = 0; x < kSize.x; ++x) {
                const dvec3 direction = scene::rayDirectionWorld(scene.camera, dvec2(x, y) + 0.5, kSize);
                const dvec3 point = scene.camera.positionWorld - scene.camera.positionWorld.y / direction.y * direction;
                const dvec3 toLight = scene.lights[0].positionWorld - point;
                const double expected = 0.6 / glm::pi<double>() * 5 * toLight.y / std::pow(glm::length(toLight), 3);
                const double shown = static_cast<double>(texels[static_cast<std::size_t>(y * kSize.x + x)].r);
                worst = std::max(worst, std::abs(shown / expected - 1));
                ++compared;
            }
        EXPECT_EQ(compared, kSize.x * kSize.y);
        return worst;
    };
    EXPECT_LT(worst("direct=pixels"), 2e-3) << "half floats have 11 bits, and two are added";
    EXPECT_GT(worst("direct=patches"), 0.05);
}

// In a room the two parts make a whole: on average as bright as with the direct light of a light map, to which it was compared with
// paths followed by chance.
TEST_F(RadiosityPixelLightTest, BothPartsAreOneWhole) {
    const scene::Snapshot scene = builtIn("cornell-room");
    testing::TechniqueSlot radiosity("radiosity", scene);
    double pixels = 0, map = 0;
    for (const vec4& texel : radiosity.radiance({"direct=pixels"}, kSize))
        pixels += static_cast<double>(texel.g);
    for (const vec4& texel : radiosity.radiance({"direct=light-map"}, kSize))
        map += static_cast<double>(texel.g);
    // A light map interpolates between points some centimetres apart.
    EXPECT_NEAR(pixels / map, 1, 0.005);
    EXPECT_GT(pixels, 1000);
}

// Form factors take a while. Direct light is there before them, and what is reflected only adds to it.
TEST_F(RadiosityPixelLightTest, DirectLightIsThereBeforeFormFactors) {
    scene::Scene dark = *builtIn("cornell-room");
    dark.ambient = vec3(0.0f);
    const scene::Snapshot scene = testing::snapshot(dark);
    picture::Session session(scene);
    std::vector<picture::Slot> slots;
    slots.push_back(picture::Session::makeSlot("radiosity"));
    lab::applySettings(slots, {"radiosity.patches=2000"}); // enough to be seconds of work
    View view;
    view.camera = scene->camera;
    view.size = kSize;
    const auto isLit = [](const vec4& texel) { return texel.g > 0.001f && texel.g < 1; }; // not the lamp
    std::vector<vec4> before; // the last picture without patches: the first ones show blocks of pixels
    bool isSolved = false;
    while (!isSolved) {
        FrameRequest request;
        request.deadline = std::chrono::steady_clock::now() + std::chrono::milliseconds(50);
        const picture::RenderedFrame frame = session.render(slots[0], view, request);
        const auto has = [&](const char* pass) { return std::ranges::find(frame.result.passes, pass, &StageKey::id) != frame.result.passes.end(); };
        isSolved = frame.converged || has("solve");
        if (!isSolved && has("direct")) before = gl::readTexels(slots[0].target.color);
    }
    ASSERT_GE(std::ranges::count_if(before, isLit), 1000) << "a picture before all form factors are found";
    session.render(slots[0], view, {});
    const std::vector<vec4> after = gl::readTexels(slots[0].target.color);
    double added = 0;
    int compared = 0;
    for (std::size_t i = 0; i < after.size(); ++i) {
        if (!isLit(before[i])) continue;
        EXPECT_GE(after[i].g, 0.999f * before[i].g) << "half floats have 11 bits";
        added += static_cast<double>(after[i].g - before[i].g);
        ++compared;
    }
    EXPECT_GT(compared, 1000);
    EXPECT_GT(added, 100);
}

// A lamp that moves, and an eye that moves: never a share that was found for another place.
TEST_F(RadiosityPixelLightTest, WhatMovesIsAskedAnew) {
    const scene::Snapshot scene = builtIn("cornell-room");
    picture::Session session(scene);
    std::vector<picture::Slot> slots;
    slots.push_back(picture::Session::makeSlot("radiosity"));
    lab::applySettings(slots, {"radiosity." + kFewPatches});
    View view;
    view.camera = scene->camera;
    view.size = kSize;
    scene::Snapshot now = scene;
    for (int step = 0; step < 4; ++step) {
        if (step % 2 == 1) {
            std::vector<scene::Light> lights = now->lights;
            lights[0].positionWorld.x += 0.3;
            now = scene::withLights(now, lights);
            session.setScene(now);
        } else {
            view.camera.positionWorld.x += 0.1 * step;
        }
        session.render(slots[0], view, {});
        const std::vector<vec4> kept = gl::readTexels(slots[0].target.color);
        picture::Session fresh(now);
        std::vector<picture::Slot> freshSlots;
        freshSlots.push_back(picture::Session::makeSlot("radiosity"));
        lab::applySettings(freshSlots, {"radiosity." + kFewPatches});
        fresh.render(freshSlots[0], view, {});
        EXPECT_EQ(kept, gl::readTexels(freshSlots[0].target.color)) << step;
    }
}

} // namespace
} // namespace shadowlab
