// Distributed ray tracing against closed forms: smooth edges, the lens, the shutter, penumbrae; and that the bytes depend neither
// on threads nor on where the work was interrupted.
// SPDX-License-Identifier: MIT
#include "techniques/ray_tracing/sampling/sampled_picture.h"

#include <algorithm>
#include <cstdlib>

#include <glm/gtc/constants.hpp>

#include "tests/ray_tracing/tree_of.h"
#include "tests/support/half_plane.h"

namespace shadowlab::ray_tracing {
namespace {

using testing::addMaterial;
using testing::addObject;
using testing::TracedScene;
using testing::translation;

/// A camera at the origin that looks along -z, the picture 2 m wide and high at a distance of 1 m.
scene::Scene darkScene() {
    scene::Scene scene;
    scene.materials.emplace_back();
    scene.camera.positionWorld = {0, 0, 0};
    scene.camera.targetWorld = {0, 0, -1};
    scene.camera.fovYDegrees = 90;
    scene.camera.near = 0.01;
    return scene;
}

/// A shining half plane x < `edge` at that depth, standing upright.
scene::Object& addHalfPlane(scene::Scene& scene, double edge, double depth, float emission = 1) {
    // Bounded far out of view: 8 times as wide as the picture is there.
    const double wide = 16 * depth;
    return addObject(scene,
                     testing::triangleSoup({{edge - wide, -wide, -depth},
                                            {edge, -wide, -depth},
                                            {edge, wide, -depth},
                                            {edge - wide, -wide, -depth},
                                            {edge, wide, -depth},
                                            {edge - wide, wide, -depth}}),
                     addMaterial(scene, 0, 0, 1.5, 0, emission), dmat4(1.0));
}

class Sampled {
public:
    Sampled(const scene::Scene& scene, ivec2 size) : traced_(scene), camera_(scene.camera), size_(size) {
        picture_.restart(size);
    }
    /// Until all is done, in slices of that length.
    void run(const SampledSettings& settings, std::chrono::microseconds slice = std::chrono::hours(1)) {
        trace::MovingScene moving(traced_.tracer(), trace::Structure::bvh);
        ASSERT_TRUE(moving.advance(Deadline::max()));
        picture_.restart(size_);
        slices_ = 1;
        while (!picture_.advance(traced_.surfaces(), moving, nullptr, camera_, settings,
                                 std::chrono::steady_clock::now() + slice))
            ++slices_;
    }
    [[nodiscard]] double at(int x, int y) const {
        return picture_.radianceFromBelow()[static_cast<std::size_t>((size_.y - 1 - y) * size_.x + x)].x;
    }
    [[nodiscard]] const SampledPicture& picture() const { return picture_; }
    [[nodiscard]] int slices() const { return slices_; }

private:
    TracedScene traced_;
    scene::Camera camera_;
    ivec2 size_;
    SampledPicture picture_;
    int slices_ = 0;
};

SampledSettings samples(int count, SamplePattern::Spread spread = SamplePattern::Spread::jittered) {
    SampledSettings settings;
    settings.pattern.count = count;
    settings.pattern.spread = spread;
    settings.tree.depth = 4;
    return settings;
}

TEST(SampledPicture, APixelHasTheShareOfItThatAnEdgeLeaves) {
    // 8 pixels of 1/4 m at 1 m; the edge lies 0.3 of a pixel into the fifth.
    scene::Scene scene = darkScene();
    addHalfPlane(scene, 0.3 / 4, 1);
    Sampled sampled(scene, {8, 8});
    sampled.run(samples(256));
    double sum = 0;
    for (int y = 0; y < 8; ++y) {
        EXPECT_EQ(sampled.at(3, y), 1);
        EXPECT_EQ(sampled.at(5, y), 0);
        // An upright edge in 16 columns: only the column that it cuts is left to chance, (16 rows) 0.3 * 16 = 4.8.
        EXPECT_NEAR(sampled.at(4, y), 0.3, 4 * std::sqrt(0.8 * 0.2 * 16) / 256);
        sum += sampled.at(4, y) / 8;
    }
    EXPECT_NEAR(sum, 0.3, 4 * std::sqrt(0.8 * 0.2 * 16 / 8) / 256);
    SampledSettings middle = samples(16);
    middle.antialias = false;
    sampled.run(middle); // through the middle of the pixel, which the edge does not reach
    EXPECT_EQ(sampled.at(4, 4), 0);
}

// --- the lens

TEST(Lens, WhatLiesInThePlaneOfFocusIsMetByAllRaysInOnePlace) {
    const scene::Scene scene = darkScene();
    const TracedScene traced(scene);
    const trace::EyeRays rays = traced.tracer().eyeRays(scene.camera, {64, 64});
    SampledSettings settings = samples(64);
    settings.antialias = false;
    settings.aperture = 0.5;
    settings.focus = 2;
    double widest = 0;
    for (const ivec2 pixel : {ivec2(32, 32), ivec2(0, 0), ivec2(63, 20)}) {
        const trace::Ray pinhole = rays.through(dvec2(pixel) + 0.5);
        for (std::uint32_t i = 0; i < 64; ++i) {
            const trace::Ray ray = eyeSample(rays, settings, pixel, SampleNumbers(settings.pattern, pixel, i)).ray;
            const dvec3 inFocus = ray.originCentred + 2.0 * ray.directionCentred; // 2 m along the axis, also at the rim
            EXPECT_LT(glm::length(inFocus - (pinhole.originCentred + 2.0 * pinhole.directionCentred)), 1e-14);
            EXPECT_NEAR(ray.directionCentred.z, -1, 1e-15);
            const double fromMiddle = glm::length(ray.originCentred - pinhole.originCentred);
            EXPECT_LE(fromMiddle, 0.25 + 1e-15);
            widest = std::max(widest, fromMiddle);
        }
    }
    EXPECT_GT(widest, 0.24);
}

TEST(Lens, CirclesOfConfusionAreThoseOfALensOfFiftyMillimetres) {
    // f = 50 mm at f/2, focused at 2 m: on the film, f / (S - f) of what it is in the plane of focus.
    constexpr double kFocal = 0.05, kAperture = 0.025, kFocus = 2;
    const scene::Scene scene = darkScene();
    const TracedScene traced(scene);
    const trace::EyeRays rays = traced.tracer().eyeRays(scene.camera, {64, 64});
    SampledSettings settings = samples(4096);
    settings.antialias = false;
    settings.aperture = kAperture;
    settings.focus = kFocus;
    for (const auto& [depth, circleMm] :
         {std::pair(1.0, 0.641026), std::pair(4.0, 0.320513), std::pair(1e9, 0.641026)}) {
        // A point at that depth on the axis: rays to it from all over the lens, and where they pass the plane of focus.
        double widest = 0;
        for (std::uint32_t i = 0; i < 4096; ++i) {
            const SampleNumbers numbers(settings.pattern, {32, 32}, i);
            const dvec3 onLens = eyeSample(rays, settings, {32, 32}, numbers).ray.originCentred - rays.eyeCentred();
            widest = std::max(widest, glm::length(onLens) * std::abs(1 - kFocus / depth));
        }
        // 4096 points on the disc come as near to its rim as 1 / (2 * 64) of the radius, and nearer.
        EXPECT_NEAR(2 * widest * kFocal / (kFocus - kFocal) * 1000, circleMm, circleMm / 128);
        EXPECT_LE(2 * widest * kFocal / (kFocus - kFocal) * 1000, circleMm * (1 + 1e-9) + 1e-6);
    }
}

/// How much of a half plane out of focus a lens sees: u from -1 to 1 across the circle of confusion.
double discProfile(double u) { return 0.5 + (u * std::sqrt(1 - u * u) + std::asin(u)) / glm::pi<double>(); }

TEST(Lens, AnEdgeOutOfFocusHasTheProfileOfADisc) {
    EXPECT_NEAR(discProfile(0.5), 0.80449889, 1e-8);
    scene::Scene scene = darkScene();
    constexpr double kDepth = 1, kFocus = 2, kAperture = 0.4;
    addHalfPlane(scene, 0, kDepth);
    constexpr int kPixels = 64, kSamples = 1024;
    Sampled sampled(scene, {kPixels, kPixels});
    SampledSettings settings = samples(kSamples);
    settings.antialias = false; // one line of sight for each pixel
    settings.aperture = kAperture;
    settings.focus = kFocus;
    sampled.run(settings);
    double squares = 0, squaresOfSquare = 0;
    int compared = 0;
    for (int x = 0; x < kPixels; ++x) {
        // Seen through a place l on the lens, the pixel's line is at depth D at X D + l (1 - D / S).
        const double across = (2 * (x + 0.5) / kPixels - 1) * kDepth;
        const double u = -across / (0.5 * kAperture * (1 - kDepth / kFocus));
        if (std::abs(u) >= 1) {
            EXPECT_EQ(sampled.at(x, 30), u > 0 ? 1 : 0);
            continue;
        }
        for (int y = 0; y < kPixels; ++y, ++compared) {
            squares += std::pow(sampled.at(x, y) - discProfile(u), 2);
            squaresOfSquare += std::pow(sampled.at(x, y) - (1 + u) / 2, 2);
        }
    }
    ASSERT_GE(compared, 6 * kPixels);
    const double rms = std::sqrt(squares / compared);
    // By chance alone sqrt(1/4 / N) would be the most; in cells it is a fraction of that.
    EXPECT_LT(rms, 0.5 / std::sqrt(kSamples));
    // The classical fault, a square aperture, has a straight profile: the test tells the two apart.
    EXPECT_GT(std::sqrt(squaresOfSquare / compared), 3 * rms);
}

// --- the shutter

TEST(Shutter, AMovingEdgeBecomesARampOfTheWayThatItGoes) {
    scene::Scene scene = darkScene();
    constexpr int kPixels = 64, kSamples = 256;
    constexpr double kWay = 20.0; // pixels in one unit of time, to the right
    addHalfPlane(scene, -10 * 2.0 / kPixels, 1).velocityWorld = {kWay * 2.0 / kPixels, 0, 0};
    Sampled sampled(scene, {kPixels, kPixels});
    for (const double shutter : {1.0, 0.5}) {
        SampledSettings settings = samples(kSamples);
        settings.shutter = shutter;
        settings.antialias = false;
        sampled.run(settings);
        double worst = 0;
        int compared = 0;
        for (int x = 0; x < kPixels; ++x) {
            // The edge begins at pixel 22 and passes the middle of pixel x after a part of the time; then it shines there.
            const double passed = (x + 0.5 - (kPixels / 2 - 10)) / (kWay * shutter);
            const double expected = 1 - std::clamp(passed, 0.0, 1.0);
            for (int y = 0; y < kPixels; ++y) {
                worst = std::max(worst, std::abs(sampled.at(x, y) - expected));
                compared += expected > 0 && expected < 1 ? 1 : 0;
            }
        }
        // One time in each of 256 equal parts: only the part in which the edge passes is left to chance.
        EXPECT_LE(worst, 1.0 / kSamples + 1e-12);
        EXPECT_GE(compared, shutter * kWay * kPixels * 0.9);
        // The fault that is looked for, the mean of begin and end, is one half all along.
        EXPECT_GT(0.4, 3 * worst);
    }
}

TEST(Shutter, ShadowsMoveWithWhatCastsThem) {
    // A lid passes under a lamp at constant speed: a point of the floor is dark for the part of the time that the lid is over it.
    scene::Scene scene = testing::floorScene();
    scene.lights.push_back(testing::pointLight({0, 4, 0}));
    scene::Object& lid = addObject(scene, scene::makeQuad({1, 1}), translation({-2, 2, 0}));
    lid.velocityWorld = {4, 0, 0}; // its shadow, twice as large and as fast, is 2 m long and goes 8 m
    const TracedScene traced(scene);
    trace::MovingScene moving(traced.tracer(), trace::Structure::bvh);
    ASSERT_TRUE(moving.moves());
    ASSERT_TRUE(moving.advance(Deadline::max()));
    int compared = 0;
    for (double x = -3.9; x < 4; x += 0.37) {
        const dvec3 fromWorld(x, 1, 0.3);
        const trace::SurfacePoint floor =
            traced.tracer().nextPoint(traced.centred(fromWorld), trace::kNoPrimitive, dvec3(0, -1, 0));
        ASSERT_TRUE(floor);
        int dark = 0;
        constexpr int kTimes = 1000;
        for (int i = 0; i < kTimes; ++i) {
            RayTree tree;
            tree.trace({traced.surfaces(), moving, (i + 0.5) / kTimes}, {}, traced.centred(fromWorld), {0, -1, 0},
                       floor, {});
            dark += tree.lightsOf(tree.root())[0].visibility == trace::Visibility::shadowed ? 1 : 0;
        }
        // The shadow's front is at -3 + 8 t, its end at -5 + 8 t.
        const double from = std::clamp((x + 3) / 8, 0.0, 1.0), to = std::clamp((x + 5) / 8, 0.0, 1.0);
        EXPECT_NEAR(dark / static_cast<double>(kTimes), to - from, 2.0 / kTimes) << x;
        compared += dark > 0 ? 1 : 0;
    }
    EXPECT_GE(compared, 15);
}

// --- the same bytes

scene::Scene everything() {
    scene::Scene scene = testing::simpleScene();
    scene.lights.push_back(testing::squareLight({1, 4, 0}));
    scene.objects[1].velocityWorld = {0.5, 0, 0};
    scene.materials.front().reflectivity = 0.4;
    scene.materials.front().glossDegrees = 8;
    return scene;
}

SampledSettings allOfIt() {
    SampledSettings settings = samples(8);
    settings.aperture = 0.1;
    settings.focus = 6;
    settings.shutter = 1;
    settings.tree.areaLights = AreaLights::sampled;
    settings.tree.gloss = settings.tree.translucency = settings.tree.interreflection = true;
    settings.tree.depth = 3;
    return settings;
}

TEST(SampledPicture, IsTheSameForAnyThreadsAndInterruptions) {
    Sampled sampled(everything(), {48, 40});
    sampled.run(allOfIt());
    const std::vector<vec3> expected = sampled.picture().radianceFromBelow();
    EXPECT_GT(std::ranges::count_if(expected, [](const vec3& v) { return v.x > 0.02f; }), 500);
    for (const char* threads : {"1", "2", "4"}) {
        setenv("SHADOWLAB_THREADS", threads, 1);
        sampled.run(allOfIt(), std::chrono::microseconds(500));
        EXPECT_EQ(sampled.picture().radianceFromBelow(), expected) << threads;
        EXPECT_GT(sampled.slices(), 3);
    }
    unsetenv("SHADOWLAB_THREADS");
}

// --- adaptive sampling

TEST(Adaptive, EvenPixelsGetFewSamplesAndEdgesAsManyAsTheyNeed) {
    scene::Scene scene = darkScene();
    addHalfPlane(scene, 0.33 / 16, 1);
    Sampled sampled(scene, {32, 32});
    SampledSettings settings = samples(1024, SamplePattern::Spread::random);
    settings.adaptive = true;
    settings.tolerance = 4;
    sampled.run(settings);
    const std::vector<std::uint32_t> counts = sampled.picture().samples();
    double squares = 0;
    for (std::size_t y = 0; y < 32; ++y) {
        EXPECT_EQ(counts[y * 32 + 3], 16u); // even
        EXPECT_EQ(counts[y * 32 + 29], 16u);
        EXPECT_GT(counts[y * 32 + 16], 32u); // the edge
        EXPECT_LT(counts[y * 32 + 16], 1024u);
        EXPECT_GT(counts[y * 32 + 17], 16u); // beside it
        squares += std::pow(sampled.at(16, static_cast<int>(y)) - 0.33, 2);
    }
    // 4 steps of grey of 255 at a linear 0.33, where the curve is 0.8 steep: 0.0195. Stopping where the estimate is met makes it a
    // little larger than that; 32 pixels know it to an eighth.
    EXPECT_LT(std::sqrt(squares / 32), 1.5 * 0.0195);
    settings.adaptive = false;
    sampled.run(settings);
    EXPECT_EQ(sampled.picture().samplesInAll(), 32.0 * 32 * 1024);
}

} // namespace
} // namespace shadowlab::ray_tracing
