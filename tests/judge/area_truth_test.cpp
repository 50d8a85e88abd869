// The truth about a light's area: shares, ties where they pass one half, and the same numbers for any number of threads.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <iostream>

#include "app/judge/truth_tiles.h"
#include "app/judge/verdict.h"
#include "techniques/foundation/scene/model/shapes.h"
#include "techniques/foundation/trace/area/area_visibility.h"
#include "techniques/foundation/trace/parallel.h"
#include "tests/support/area_lights.h"
#include "tests/support/hard_scenes.h"
#include "tests/support/scenes.h"

namespace shadowlab::judge {
namespace {

using testing::rectLight, testing::sphereLight, testing::tracerOf;
using trace::Visibility;

constexpr ivec2 kSize{96, 72};
constexpr double kTiePx = 1.0 / 64.0;

/// The scenes of these tests, each under a panel and under a ball.
std::vector<scene::Snapshot> scenes() {
    std::vector<scene::Snapshot> made;
    for (const bool soup : {false, true})
        for (const scene::Light& light :
             {rectLight({2, 4, 2.5}, {1, 0, -1}, {-0.5, -1.2, -0.5}), sphereLight({2, 4, 2.5}, 0.6)}) {
            scene::Scene scene =
                soup ? testing::hardScene(testing::HardClass::soup, 4, false) : testing::everyKindOfLight();
            scene.lights = {light};
            made.push_back(testing::snapshot(std::move(scene)));
        }
    return made;
}

Truth exact(const scene::Snapshot& snapshot, double tiePx = kTiePx) {
    return exactTruth(tracerOf(snapshot), snapshot->camera, kSize, 0, {tiePx, {}}, {}, TruthOf::area);
}

/// What one point of the picture sees, asked alone.
Visibility at(const trace::SceneTracer& tracer, const trace::AreaVisibility& area, const trace::EyeRays& rays,
              dvec2 pixel) {
    const trace::SurfacePoint point = tracer.eyePoint(rays, pixel);
    if (!point) return Visibility::noSurface;
    if (!tracer.facesLight(point, 0)) return Visibility::turnedAway;
    return area.share(point) > 0.5 ? Visibility::lit : Visibility::shadowed;
}

// Points around a centre are left out where the share cannot pass one half on the way to them. A wide radius makes many ties.
TEST(AreaTruth, TiesAreThoseThatAllPointsAroundTell) {
    for (const double tiePx : {kTiePx, 0.25}) {
        int compared = 0, ties = 0, otherwise = 0;
        for (const scene::Snapshot& snapshot : scenes()) {
            const trace::SceneTracer tracer = tracerOf(snapshot);
            const trace::AreaVisibility area(tracer, 0);
            const trace::EyeRays rays = tracer.eyeRays(snapshot->camera, kSize);
            const Truth truth = exact(snapshot, tiePx);
            for (int y = 0; y < kSize.y; ++y)
                for (int x = 0; x < kSize.x; ++x) {
                    const Visibility centre = at(tracer, area, rays, dvec2(x, y) + 0.5);
                    bool tie = false;
                    for (int step = 0; step < kPointsAround && !tie; ++step)
                        tie = at(tracer, area, rays, dvec2(x, y) + pointAround(step, tiePx)) != centre;
                    const std::size_t i = truth.index(x, y);
                    EXPECT_EQ(truth.visibility[i], centre) << x << ' ' << y;
                    otherwise += tie != (truth.ties[i] != 0);
                    ties += tie;
                    ++compared;
                }
        }
        std::cout << ties << " ties of " << compared << '\n';
        EXPECT_EQ(otherwise, 0);
        EXPECT_GT(compared, 20'000);
        EXPECT_GT(ties, tiePx > kTiePx ? 500 : 20);
        EXPECT_LT(ties, compared / 4);
    }
}

TEST(AreaTruth, SharesAndWhatTheyMean) {
    int partly = 0, without = 0;
    for (const scene::Snapshot& snapshot : scenes()) {
        const trace::SceneTracer tracer = tracerOf(snapshot);
        const trace::AreaVisibility area(tracer, 0);
        const trace::EyeRays rays = tracer.eyeRays(snapshot->camera, kSize);
        const Truth truth = truthAtCentres(tracer, snapshot->camera, kSize, 0, {}, TruthOf::area);
        for (int y = 0; y < kSize.y; ++y)
            for (int x = 0; x < kSize.x; ++x) {
                const std::size_t i = truth.index(x, y);
                const trace::SurfacePoint point = tracer.eyePoint(rays, dvec2(x, y) + 0.5);
                // As float, and of pieces cut in another order.
                EXPECT_NEAR(truth.share(i), area.share(point), 1e-7);
                EXPECT_EQ(truth.visibility[i] == Visibility::lit, truth.share(i) > 0.5);
                partly += truth.share(i) > 0.001 && truth.share(i) < 0.999;
                const bool receives = !point || tracer.objectOf(point).receivesShadow;
                if (receives) continue;
                ++without;
                EXPECT_EQ(truth.share(i), truth.visibility[i] == Visibility::turnedAway ? 0.0 : 1.0);
            }
    }
    EXPECT_GT(partly, 1000);
    EXPECT_GT(without, 50);
}

TEST(AreaTruth, TheSameForAnyNumberOfThreads) {
    for (const scene::Snapshot& snapshot : scenes()) {
        const Truth some = exact(snapshot);
        setenv("SHADOWLAB_THREADS", "1", 1);
        const Truth one = exact(snapshot);
        setenv("SHADOWLAB_THREADS", "5", 1);
        const Truth five = exact(snapshot);
        unsetenv("SHADOWLAB_THREADS");
        EXPECT_EQ(one.shares, some.shares);
        EXPECT_EQ(five.shares, some.shares);
        EXPECT_EQ(one.ties, five.ties);
        EXPECT_EQ(one.visibility, five.visibility);
    }
}

TEST(AreaTruth, TiesOfAFewPixelsAreThoseOfThePicture) {
    const scene::Snapshot snapshot = scenes()[0];
    const trace::SceneTracer tracer = tracerOf(snapshot);
    const Truth truth = exact(snapshot, 0.25);
    std::vector<ivec2> pixels;
    for (int y = 0; y < kSize.y; ++y)
        for (int x = y % 3; x < kSize.x; x += 3)
            pixels.emplace_back(x, y);
    const std::vector<std::uint8_t> ties = tiesAmong(tracer, snapshot->camera, kSize, 0, 0.25, pixels, TruthOf::area);
    int found = 0;
    for (std::size_t i = 0; i < pixels.size(); ++i) {
        EXPECT_EQ(ties[i], truth.ties[truth.index(pixels[i].x, pixels[i].y)]);
        found += ties[i];
    }
    EXPECT_GT(found, 30);
}

TEST(AreaTruth, StopsWhenAskedTo) {
    const scene::Snapshot snapshot = scenes()[0];
    const trace::SceneTracer tracer = tracerOf(snapshot);
    std::stop_source stop;
    stop.request_stop();
    EXPECT_THROW(truthAtCentres(tracer, snapshot->camera, kSize, 0, stop.get_token(), TruthOf::area), trace::Stopped);
    EXPECT_THROW(exactTruth(tracer, snapshot->camera, kSize, 0, {kTiePx, {}}, stop.get_token(), TruthOf::area),
                 trace::Stopped);
}

// What a rasteriser shows instead of the triangle that the ray found: a tie where that one sees less than half of the light and
// this one more.
TEST(AreaTruth, AnotherTriangleMayBeShownWhereItSeesTheOtherHalf) {
    scene::Scene scene = testing::floorScene();
    testing::addObject(scene, scene::makeQuad({9, 9}), testing::translation({0, 0.25, 0}));
    scene.lights = {rectLight({0, 4, 0}, {1, 0, 0}, {0, 0, 1})};
    const scene::Snapshot snapshot = testing::snapshot(std::move(scene));
    const trace::SceneTracer tracer = tracerOf(snapshot);
    const std::size_t pixels = static_cast<std::size_t>(kSize.x) * kSize.y;
    // The floor, which lies in the shadow of the lid that is seen.
    const Rasterised shown{kTiePx, std::vector<std::uint32_t>(pixels, 0)};
    const Truth plain = exactTruth(tracer, snapshot->camera, kSize, 0, {kTiePx, {}}, {}, TruthOf::area);
    const Truth truth = exactTruth(tracer, snapshot->camera, kSize, 0, shown, {}, TruthOf::area);
    const std::size_t middle = truth.index(kSize.x / 2, kSize.y / 2);
    EXPECT_EQ(plain.visibility[middle], Visibility::lit);
    EXPECT_EQ(plain.ties[middle], 0);
    EXPECT_EQ(truth.ties[middle], 1);
}

TEST(AreaTruth, IsHeldAgainstSharesAndCutAtOneHalf) {
    Truth truth = emptyTruth({5, 1});
    truth.visibility = {Visibility::lit, Visibility::lit, Visibility::shadowed, Visibility::shadowed,
                        Visibility::turnedAway};
    truth.shares = {1.0f, 0.6f, 0.2f, 0.0f, 0.0f};
    truth.objects = {0, 0, 0, 0, 0};
    const auto image = [](const std::array<int, 5>& greys) {
        std::vector<std::uint8_t> bytes;
        for (const int grey : greys)
            for (const int value : {grey, 255})
                bytes.push_back(static_cast<std::uint8_t>(value));
        return bytes;
    };
    const Judgement right = judge(truth, image({255, 153, 51, 0, 0}));
    EXPECT_EQ(right.counts.wrong(), 0);
    EXPECT_EQ(right.counts.lit, 2);
    EXPECT_EQ(right.counts.shadowed, 2);
    EXPECT_EQ(right.counts.turnedAway, 1);
    EXPECT_NEAR(right.counts.rmse, 0, 1e-7); // 0.6 and 0.2 are steps of a byte, and floats
    const Judgement hard = judge(truth, image({255, 255, 0, 0, 0}));
    EXPECT_EQ(hard.counts.wrong(), 0) << "on the right side of one half";
    EXPECT_NEAR(hard.counts.rmse, std::sqrt((0.4 * 0.4 + 0.2 * 0.2) / 5), 1e-7);
    const Judgement wrong = judge(truth, image({255, 102, 204, 0, 0}));
    EXPECT_EQ(wrong.verdicts[1], Verdict::falseShadow);
    EXPECT_EQ(wrong.verdicts[2], Verdict::falseLit);
}

} // namespace
} // namespace shadowlab::judge
