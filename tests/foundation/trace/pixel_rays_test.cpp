// Rays through scattered pixels, asked for one light after the other: the answers are those of single rays, whatever was remembered.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <random>

#include "techniques/foundation/math/morton.h"
#include "techniques/foundation/trace/packets/pixel_rays.h"
#include "tests/support/scenes.h"

namespace shadowlab::trace {
namespace {

std::vector<ivec2> scattered(ivec2 size, std::mt19937& random) {
    std::vector<ivec2> pixels;
    for (int y = 0; y < size.y; ++y)
        for (int x = 0; x < size.x; ++x)
            if (random() % 5 == 0 || (x / 8 + y / 8) % 7 == 0) pixels.emplace_back(x, y); // a few of each block, and all of some
    sortByBlock(pixels);
    return pixels;
}

// Bits of 3 = 011 and 5 = 101, those of the first coordinate below: 10 01 11.
TEST(PixelRaysTest, MortonsCurveTakesTheBitsInTurn) {
    EXPECT_EQ(alongMortonCurve(ivec2(3, 5), 3), 0b100111u);
    EXPECT_EQ(alongMortonCurve(ivec2(3, 5), 2), 0b0111u) << "two bits of each";
    EXPECT_EQ(alongMortonCurve(glm::ivec3(1, 0, 2), 2), 0b100001u);
}

struct Answers {
    long lit = 0, shadowed = 0, turnedAway = 0, noSurface = 0;
};

TEST(PixelRaysTest, AreThoseOfSingleRaysWhateverIsRemembered) {
    std::mt19937 random(3);
    scene::Scene scene = testing::simpleScene();
    scene::Camera camera = scene.camera;
    PixelRays rays;
    Answers sum;
    ivec2 size(101, 67); // blocks at the rims are cut
    std::size_t remembered = 0;
    for (int frame = 0; frame < 24; ++frame) {
        const bool onlyLight = frame % 6 != 5;
        scene.lights[0].positionWorld.x += 0.15;
        scene.revisions.lights = scene::newRevision();
        if (frame == 5) camera.positionWorld.y += 0.5;
        if (frame == 11) {
            scene.objects[1].worldFromObject = testing::translation({0.2, 0, 0}) * scene.objects[1].worldFromObject;
            scene.revisions.transforms = scene::newRevision();
        }
        if (frame == 17) size = {64, 99};
        if (frame == 23) scene.revisions.materials = scene::newRevision();
        SceneTracer tracer;
        ASSERT_TRUE(tracer.advance(testing::snapshot(scene), std::chrono::steady_clock::time_point::max()));
        const std::vector<ivec2> pixels = scattered(size, random);
        const std::vector<Visibility> answers = rays.visibilities(pixels, tracer, camera, size, 0);
        ASSERT_EQ(answers.size(), pixels.size());
        const EyeRays eye = tracer.eyeRays(camera, size);
        for (std::size_t i = 0; i < pixels.size(); ++i) {
            const Visibility alone = tracer.visibility(tracer.eyePoint(eye, dvec2(pixels[i]) + 0.5), 0);
            ASSERT_EQ(answers[i], alone) << "frame " << frame << ", pixel " << pixels[i].x << ' ' << pixels[i].y;
            ++(alone == Visibility::lit        ? sum.lit
               : alone == Visibility::shadowed ? sum.shadowed
               : alone == Visibility::noSurface ? sum.noSurface
                                                : sum.turnedAway);
        }
        if (frame > 0 && onlyLight) EXPECT_GE(rays.remembered(), remembered) << "only the light has moved";
        remembered = rays.remembered();
        EXPECT_GT(remembered, 20u);
    }
    EXPECT_GT(sum.lit, 10'000);
    EXPECT_GT(sum.shadowed, 1'000);
    EXPECT_GT(sum.turnedAway, 100);
    EXPECT_GT(sum.noSurface, 1'000);
}

} // namespace
} // namespace shadowlab::trace
