// How many rays a second? Says nothing about right or wrong, so it only runs when asked for: SHADOWLAB_LONG=1.
// Coherent rays (neighbouring pixels) and incoherent ones (anywhere to anywhere) are different questions.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <functional>

#include "techniques/foundation/scene/shapes.h"
#include "techniques/foundation/trace/bvh_traverse.h"
#include "techniques/foundation/trace/engine.h"
#include "techniques/foundation/trace/parallel.h"
#include "techniques/foundation/trace/scene_tracer.h"
#include "tests/foundation/trace/ray_meshes.h"
#include "tests/support/scenes.h"

namespace shadowlab::trace {
namespace {

using Clock = std::chrono::steady_clock;

/// Milliseconds, median of seven.
double medianMs(const std::function<void()>& work) {
    std::vector<double> times;
    for (int i = 0; i < 7; ++i) {
        const auto begin = Clock::now();
        work();
        times.push_back(std::chrono::duration<double, std::milli>(Clock::now() - begin).count());
    }
    std::ranges::nth_element(times, times.begin() + 3);
    return times[3];
}

TEST(RayRate, OfAMeshOfSixtyThousandTriangles) {
    if (!std::getenv("SHADOWLAB_LONG")) GTEST_SKIP() << "a measurement; set SHADOWLAB_LONG=1";
    scene::Scene scene = testing::floorScene();
    testing::addObject(scene, scene::makeTorus(0.7, 0.28, {250, 128}), testing::translation({0, 1.2, 0}));
    scene.objects[1].worldFromObject =
        scene.objects[1].worldFromObject * dmat4(dmat3(dvec3(1, 0, 0), dvec3(0, 0.6, 0.8), dvec3(0, -0.8, 0.6)));
    scene.lights.push_back(testing::pointLight({4, 6, 0}));
    scene.camera.targetWorld = {0, 0.9, 0};
    scene.camera.fovYDegrees = 45;
    const auto snapshot = testing::snapshot(scene);
    SceneTracer tracer;
    const double buildMs = medianMs([&] {
        tracer = SceneTracer();
        tracer.advance(snapshot, Clock::time_point::max());
    });

    const ivec2 size{1280, 720};
    const auto rays = tracer.eyeRays(scene.camera, size);
    std::vector<SurfacePoint> points(static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y));
    const auto rows = static_cast<std::size_t>(size.y), columns = static_cast<std::size_t>(size.x);
    const double eyeMs = medianMs([&] {
        parallelFor(rows, [&](std::size_t y) {
            for (std::size_t x = 0; x < columns; ++x)
                points[y * columns + x] = tracer.eyePoint(rays, dvec2(x, y) + 0.5);
        });
    });
    std::vector<std::uint8_t> blocked(points.size());
    const auto sent = static_cast<double>(
        std::ranges::count_if(points, [&](const SurfacePoint& point) { return point && tracer.facesLight(point, 0); }));
    const double shadowMs = medianMs([&] {
        parallelFor(rows, [&](std::size_t y) {
            for (std::size_t i = y * columns; i < (y + 1) * columns; ++i)
                blocked[i] = tracer.visibility(points[i], 0) == Visibility::shadowed ? 1 : 0;
        });
    });
    // Embree answering the same eye rays, one at a time, through the common interface.
    const auto embree = makeEmbreeEngine(tracer.world().triangles);
    std::atomic<long> embreeHits = 0;
    const double embreeMs = !embree ? 0 : medianMs([&] {
        parallelFor(rows, [&](std::size_t y) {
            long found = 0;
            for (std::size_t x = 0; x < columns; ++x)
                found += bool(embree->closest(rays.through(dvec2(x, y) + 0.5)));
            embreeHits += found;
        });
    });
    constexpr std::size_t kPieces = 100, kPerPiece = 10'000;
    std::atomic<long> hits = 0;
    const double randomMs = medianMs([&] {
        parallelFor(kPieces, [&](std::size_t piece) {
            testing::Random random(piece);
            long found = 0;
            for (std::size_t i = 0; i < kPerPiece; ++i) {
                Ray ray;
                ray.originCentred = testing::inCube(random, 1.5);
                ray.directionCentred = testing::inCube(random, 1.5) - ray.originCentred;
                found += bool(tracer.bvh().closest(ray));
            }
            hits += found;
        });
    });
    EXPECT_GT(std::ranges::count(blocked, 1), 1000);
    EXPECT_GT(hits, 1000);
    const auto rate = [](double count, double ms) { return count / ms / 1000; };
    std::cout << triangleCount(*snapshot) << " triangles, " << threadCount() << " threads, tree built in " << buildMs
              << " ms, depth " << tracer.bvh().depth << "\n"
              << "eye rays    " << eyeMs << " ms, " << rate(static_cast<double>(points.size()), eyeMs) << " Mrays/s\n"
              << "  by Embree " << embreeMs << " ms, " << rate(static_cast<double>(points.size()), embreeMs)
              << " Mrays/s\n"
              << "shadow rays " << shadowMs << " ms, " << rate(sent, shadowMs) << " Mrays/s\n"
              << "random rays " << randomMs << " ms, " << rate(kPieces * kPerPiece, randomMs) << " Mrays/s\n";
}

} // namespace
} // namespace shadowlab::trace
