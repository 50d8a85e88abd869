// Shadows that change from frame to frame although the truth does not: at pixels (ExcessFlips), and at points that are followed
// while the eye moves (Crawl).
// SPDX-License-Identifier: MIT
#include "app/judge/metrics/flicker.h"

#include <chrono>
#include <cmath>

#include <gtest/gtest.h>

#include "techniques/foundation/scene/model/shapes.h"
#include "tests/support/scenes.h"

namespace shadowlab::judge {
namespace {

using Mask = std::vector<std::uint8_t>;

TEST(ExcessFlips, OfTheTruthItselfAreNone) {
    ExcessFlips flips;
    for (int frame = 0; frame < 5; ++frame) {
        Mask mask(10, 0);
        mask[static_cast<std::size_t>(frame)] = 1;
        flips.addFrame(mask, mask, 3.0);
    }
    EXPECT_EQ(flips.rate(), 0.0);
}

TEST(ExcessFlips, AreCountedPerPixelOfBoundary) {
    ExcessFlips flips;
    const Mask truth(10, 1);
    flips.addFrame({1, 1, 1, 1, 1, 1, 1, 1, 1, 1}, truth, 100.0); // the first frame has nothing to differ from
    flips.addFrame({0, 0, 1, 1, 1, 1, 1, 1, 1, 1}, truth, 4.0);   // 2
    flips.addFrame({0, 0, 1, 1, 1, 1, 1, 1, 1, 0}, truth, 4.0);   // 1
    flips.addFrame({1, 1, 1, 1, 1, 1, 1, 1, 1, 1}, truth, 2.0);   // 3
    EXPECT_DOUBLE_EQ(*flips.rate(), 6.0 / 10.0);
}

TEST(ExcessFlips, WhereTheTruthFlipsTooNothingIsExcess) {
    ExcessFlips flips;
    flips.addFrame({0, 1}, {0, 1}, 1.0);
    flips.addFrame({1, 1}, {1, 0}, 1.0); // the second pixel stays, wrongly: an error, but no flicker
    EXPECT_EQ(flips.rate(), 0.0);
}

TEST(ExcessFlips, NeedTwoFramesAndABoundary) {
    ExcessFlips one;
    one.addFrame({1}, {1}, 5.0);
    EXPECT_FALSE(one.rate());
    one.addFrame({0}, {1}, 0.0);
    EXPECT_FALSE(one.rate());
}

constexpr ivec2 kSize{64, 48};

scene::Camera fromAbove(double x) {
    scene::Camera camera;
    camera.positionWorld = {x, 10, 0};
    camera.targetWorld = {x, 0, 0};
    camera.upWorld = {0, 0, -1};
    camera.fovYDegrees = 45;
    return camera;
}

TEST(Crawl, PixelsArePlacesOfTheEyesRays) {
    const scene::Snapshot scene = testing::snapshot(testing::simpleScene());
    trace::SceneTracer tracer;
    tracer.advance(scene, std::chrono::steady_clock::time_point::max());
    const trace::EyeRays rays = tracer.eyeRays(scene->camera, kSize);
    int seen = 0;
    for (int y = 0; y < kSize.y; y += 3)
        for (int x = 0; x < kSize.x; x += 3) {
            const dvec2 pixel(x + 0.5, y + 0.5);
            const trace::SurfacePoint point = tracer.eyePoint(rays, pixel);
            if (!point) continue;
            const auto back = pixelOf(scene->camera, kSize, tracer.positionWorld(point));
            ASSERT_TRUE(back);
            EXPECT_NEAR(glm::length(*back - pixel), 0, 1e-9); // doubles, a few metres from the eye
            ++seen;
        }
    EXPECT_GT(seen, 100);
    EXPECT_FALSE(pixelOf(fromAbove(0), kSize, {0, 11, 0})) << "behind the eye";
}

TEST(Crawl, CountsPointsThatChangeAndNotPixelsThatDo) {
    scene::Scene floor = testing::floorScene();
    const scene::Snapshot scene = testing::snapshot(floor);
    trace::SceneTracer tracer;
    tracer.advance(scene, std::chrono::steady_clock::time_point::max());
    // A step by one pixel: so every pixel's middle is a pixel's middle again.
    const double step = 2 * 10 * std::tan(glm::radians(22.5)) / kSize.y;
    const auto stripes = [&](int shift) { // on the floor: they move over the pixels as the eye moves
        std::vector<std::uint8_t> lit;
        for (int y = 0; y < kSize.y; ++y)
            for (int x = 0; x < kSize.x; ++x)
                lit.push_back((x + shift) / 4 % 2 == 0);
        return lit;
    };
    const std::vector<std::uint8_t> truth(static_cast<std::size_t>(kSize.x * kSize.y), 1);
    Crawl still, crawling;
    EXPECT_FALSE(still.percent());
    for (int frame = 0; frame < 4; ++frame) {
        still.addFrame(tracer, fromAbove(frame * step), kSize, stripes(frame), truth);
        crawling.addFrame(tracer, fromAbove(frame * step), kSize, stripes(0), truth);
    }
    EXPECT_GT(still.followed(), 3 * 57 * 48); // the floor is 58 columns wide, and one of them leaves the picture
    EXPECT_EQ(still.percent(), 0);
    EXPECT_NEAR(crawling.percent().value_or(0), 25, 3); // one column of four
}

} // namespace
} // namespace shadowlab::judge
