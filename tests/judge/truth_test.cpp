// The truth against the judge that tries every triangle, and its ties against a shadow edge whose place is known.
// SPDX-License-Identifier: MIT
#include "app/judge/truth.h"

#include <gtest/gtest.h>

#include <cmath>

#include "techniques/foundation/scene/model/shapes.h"
#include "techniques/foundation/trace/parallel.h"
#include "tests/support/hard_scenes.h"
#include "tests/support/perforated.h"
#include "tests/support/scenes.h"

namespace shadowlab::judge {
namespace {

using trace::Visibility;

constexpr double kTiePx = 1.0 / 64.0;

trace::SceneTracer tracerOf(const scene::Snapshot& snapshot) {
    trace::SceneTracer tracer;
    tracer.advance(snapshot, std::chrono::steady_clock::time_point::max());
    return tracer;
}

int count(const Truth& truth, Visibility visibility) {
    return static_cast<int>(std::ranges::count(truth.visibility, visibility));
}

TEST(Truth, EqualsTheJudgeOutsideTies) {
    const ivec2 size{96, 72};
    int compared = 0, lit = 0, shadowed = 0, turnedAway = 0, ties = 0, otherwise = 0;
    for (const bool directional : {false, true})
        for (const testing::HardClass hardClass : testing::kHardClasses)
            for (unsigned number = 20; number < 23; ++number) {
                const auto snapshot = testing::snapshot(testing::hardScene(hardClass, number, directional));
                const Truth truth = exactTruth(tracerOf(snapshot), snapshot->camera, size, 0, {kTiePx, {}});
                const trace::ExactVisibility judge(snapshot);
                for (int y = 0; y < size.y; ++y)
                    for (int x = 0; x < size.x; ++x) {
                        const std::size_t i = truth.index(x, y);
                        if (truth.ties[i]) {
                            ++ties;
                            continue;
                        }
                        otherwise += truth.visibility[i] != judge.at(snapshot->camera, dvec2(x, y) + 0.5, size, 0);
                        ++compared;
                    }
                lit += count(truth, Visibility::lit);
                shadowed += count(truth, Visibility::shadowed);
                turnedAway += count(truth, Visibility::turnedAway);
            }
    EXPECT_EQ(otherwise, 0);
    EXPECT_GT(compared, 240'000);
    EXPECT_GT(lit, 10'000);
    EXPECT_GT(shadowed, 10'000);
    EXPECT_GT(turnedAway, 1'000);
    EXPECT_LT(ties, compared / 50) << "these scenes are full of edges, but not that full";
}

/// A camera straight above a floor, 10 m up, with one pixel a centimetre on the floor: 1 m is 100 pixels. The sun shines
/// straight down on a lid whose right edge lies so that its shadow ends at column `edge` of the picture.
scene::Snapshot lidScene(double edge, ivec2 size) {
    scene::Scene scene = testing::floorScene();
    scene.camera.positionWorld = {0, 10, 0};
    scene.camera.targetWorld = {0, 0, 0};
    scene.camera.upWorld = {0, 0, -1};
    scene.camera.fovYDegrees = 2 * std::atan(size.y / 200.0 / 10.0) * 180 / M_PI;
    const double edgeX = (edge - size.x / 2.0) / 100.0;
    // The lid itself is out of view: above the camera.
    const double left = -3;
    testing::addObject(
        scene, testing::triangleSoup(
                   {{left, 12, -3}, {edgeX, 12, 3}, {edgeX, 12, -3}, {left, 12, -3}, {left, 12, 3}, {edgeX, 12, 3}}));
    scene.lights.push_back(testing::directionalLight({0, -1, 0}));
    return testing::snapshot(scene);
}

/// Column 50 is beside the shadow's edge: to its left all is shadowed, to its right lit, and it is tied itself within the radius.
void expectTiesInColumn50(const Truth& truth, ivec2 size, double offset) {
    for (int x = 0; x < size.x; ++x) {
        int ties = 0;
        for (int y = 0; y < size.y; ++y)
            ties += truth.ties[truth.index(x, y)];
        EXPECT_EQ(ties, x == 50 && std::abs(offset) < kTiePx ? size.y : 0) << "column " << x << ", " << offset;
    }
    EXPECT_EQ(truth.visibility[truth.index(49, 30)], Visibility::shadowed);
    EXPECT_EQ(truth.visibility[truth.index(51, 30)], Visibility::lit);
}

// Meshes are stored in float: the lid's edge is right to 2^-24 of its coordinate, 1e-5 px here, far below the offsets.
TEST(Truth, TiesAreThePixelsWithinTheRadiusOfAnEdge) {
    const ivec2 size{80, 60};
    for (const double offset : {0.0, 0.005, 0.0150, 0.0162, 0.1, -0.0150, -0.0162}) {
        const auto snapshot = lidScene(50.5 + offset, size); // so far from the centres of column 50
        const Truth truth = exactTruth(tracerOf(snapshot), snapshot->camera, size, 0, {kTiePx, {}});
        expectTiesInColumn50(truth, size, offset);
    }
}

// The same lid, twice as wide, of which an image cuts away the right half: its shadow ends at a border between two texels.
TEST(Truth, BordersOfHolesMakeTiesAsEdgesDo) {
    const ivec2 size{80, 60};
    for (const double offset : {0.0, 0.0150, 0.0162, -0.0150, -0.0162}) {
        const scene::Snapshot whole = lidScene(50.5, size);
        scene::Scene scene = *whole;
        scene.objects.pop_back();
        const double edgeX = (50.5 + offset - size.x / 2.0) / 100.0;
        testing::addObject(scene, scene::makeQuad({6, 6}), testing::translation({edgeX, 12, 0}));
        testing::perforate(scene, 1, {"#."});
        const auto snapshot = testing::snapshot(scene);
        const Truth truth = exactTruth(tracerOf(snapshot), snapshot->camera, size, 0, {kTiePx, {}});
        expectTiesInColumn50(truth, size, offset);
    }
}

// A rasteriser that draws a triangle where it has a hole is wrong, and no tie excuses it.
TEST(Truth, WhoDrawsOverAHoleIsNotExcused) {
    const ivec2 size{80, 60};
    scene::Scene scene = testing::floorScene();
    testing::addObject(scene, scene::makeQuad({4, 4}), testing::translation({0, 1, 0})).receivesShadow = false;
    testing::perforate(scene, 1, {"#.#.", ".#.#"});
    testing::addObject(scene, scene::makeQuad({9, 9}), testing::translation({0, 2.5, -2})); // all below is in shadow
    scene.lights.push_back(testing::directionalLight({0, -1, 0.2}));
    const auto snapshot = testing::snapshot(scene);
    const trace::SceneTracer tracer = tracerOf(snapshot);
    const Truth truth = exactTruth(tracer, snapshot->camera, size, 0, {kTiePx, {}});
    scene.objects[1].partMaterials[0] = 0;
    const trace::SceneTracer solid = tracerOf(testing::snapshot(scene));
    const trace::EyeRays rays = tracer.eyeRays(scene.camera, size);
    Rasterised whole{kTiePx, {}};
    int drawnOver = 0;
    for (int y = 0; y < size.y; ++y)
        for (int x = 0; x < size.x; ++x) {
            whole.primitives.push_back(solid.eyePoint(rays, dvec2(x, y) + 0.5).primitive);
            const bool over = whole.primitives.back() != tracer.eyePoint(rays, dvec2(x, y) + 0.5).primitive;
            // The sheet is lit, whatever is above it: what is drawn over a shadow shows another truth.
            drawnOver += over && truth.visibility[truth.index(x, y)] == Visibility::shadowed;
        }
    EXPECT_GT(drawnOver, 100);
    EXPECT_EQ(exactTruth(tracer, snapshot->camera, size, 0, whole).ties, truth.ties);
}

TEST(Truth, TiesOfAFewPixelsAreThoseOfThePicture) {
    const ivec2 size{96, 72};
    const auto snapshot = testing::snapshot(testing::hardScene(testing::HardClass::soup, 21, false));
    const trace::SceneTracer tracer = tracerOf(snapshot);
    const Truth truth = exactTruth(tracer, snapshot->camera, size, 0, {1.0 / 8, {}}); // wide: more of them
    std::vector<ivec2> pixels;
    for (int y = 0; y < size.y; ++y)
        for (int x = 0; x < size.x; ++x)
            pixels.emplace_back(x, y);
    EXPECT_EQ(tiesAmong(tracer, snapshot->camera, size, 0, 1.0 / 8, pixels), truth.ties);
    EXPECT_GT(std::ranges::count(truth.ties, 1), 50);
}

TEST(Truth, WithFewerSubpixelBitsTheTieGrows) {
    EXPECT_EQ(tieRadius(8), 1.0 / 64);
    EXPECT_EQ(tieRadius(4), 1.0 / 8);
    EXPECT_EQ(tieRadius(16), 1.0 / 64);
}

// The floor under the lid and the floor beside it: what the rasteriser shows is a tie only where its answer differs.
TEST(Truth, AnotherTriangleInTheRasterIsATieWhereItsAnswerIsAnother) {
    const ivec2 size{80, 60};
    const auto base = lidScene(50.5 + 0.3, size);
    scene::Scene scene = *base;
    testing::addObject(scene, scene::makeQuad({10, 10})); // a second floor, a metre below the first
    scene.objects.back().worldFromObject = testing::translation({0, -1, 0});
    const auto snapshot = testing::snapshot(scene);
    const trace::SceneTracer tracer = tracerOf(snapshot);
    std::vector<std::uint32_t> drawn;
    for (int y = 0; y < size.y; ++y)
        for (int x = 0; x < size.x; ++x)
            drawn.push_back(tracer.eyePoint(tracer.eyeRays(snapshot->camera, size), dvec2(x, y) + 0.5).primitive);
    const auto tiesWith = [&](std::size_t index, std::uint32_t primitive) {
        std::vector<std::uint32_t> changed = drawn;
        changed[index] = primitive;
        const Truth truth = exactTruth(tracer, snapshot->camera, size, 0, {kTiePx, changed});
        return std::ranges::count(truth.ties, 1);
    };
    const Truth truth = exactTruth(tracer, snapshot->camera, size, 0, {kTiePx, drawn});
    ASSERT_EQ(std::ranges::count(truth.ties, 1), 0);
    const std::size_t lit = truth.index(70, 10), dark = truth.index(10, 10);
    const std::uint32_t other = drawn[lit] == 0 ? 1 : 0; // the floor's other triangle, in the same plane
    const std::uint32_t below = tracer.world().firstOfObject[2];
    EXPECT_EQ(tiesWith(lit, other), 0);
    EXPECT_EQ(tiesWith(dark, below), 0) << "in shadow, too";
    EXPECT_EQ(tiesWith(lit, below), 1) << "shadowed by the floor above it";
    EXPECT_EQ(tiesWith(lit, trace::kNoPrimitive), 1) << "the rasteriser leaves a hole";
}

TEST(Truth, CanBeStoppedAndIsTheSameWhereItIsNot) {
    const ivec2 size{75, 53};
    const auto snapshot = testing::snapshot(testing::hardScene(testing::HardClass::soup, 3, false));
    const trace::SceneTracer tracer = tracerOf(snapshot);
    std::stop_source source;
    const Truth plain = exactTruth(tracer, snapshot->camera, size, 0, {kTiePx, {}});
    const Truth stoppable = exactTruth(tracer, snapshot->camera, size, 0, {kTiePx, {}}, source.get_token());
    EXPECT_GT(count(plain, Visibility::lit), 500);
    EXPECT_EQ(plain.visibility, stoppable.visibility);
    EXPECT_EQ(plain.ties, stoppable.ties);
    EXPECT_EQ(plain.objects, stoppable.objects);
    source.request_stop();
    EXPECT_THROW(exactTruth(tracer, snapshot->camera, size, 0, {kTiePx, {}}, source.get_token()), trace::Stopped);
    EXPECT_THROW(truthAtCentres(tracer, snapshot->camera, size, 0, source.get_token()), trace::Stopped);
}

TEST(Truth, SameForAnyNumberOfThreads) {
    const auto snapshot = testing::snapshot(testing::hardScene(testing::HardClass::soup, 3, false));
    const trace::SceneTracer tracer = tracerOf(snapshot);
    std::vector<Truth> truths;
    for (const char* threads : {"1", "3"}) {
        setenv("SHADOWLAB_THREADS", threads, 1);
        truths.push_back(exactTruth(tracer, snapshot->camera, {75, 53}, 0, {kTiePx, {}})); // no multiple of the tile
    }
    unsetenv("SHADOWLAB_THREADS");
    EXPECT_GT(count(truths[0], Visibility::lit), 500);
    EXPECT_EQ(truths[0].visibility, truths[1].visibility);
    EXPECT_EQ(truths[0].ties, truths[1].ties);
    EXPECT_EQ(truths[0].objects, truths[1].objects);
}

} // namespace
} // namespace shadowlab::judge
