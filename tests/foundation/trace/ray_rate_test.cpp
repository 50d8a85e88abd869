// How many rays a second? Says nothing about right or wrong, so it only runs when asked for: SHADOWLAB_LONG=1.
// Coherent rays (neighbouring pixels) and incoherent ones (anywhere to anywhere) are different questions.
// SHADOWLAB_RATE_SCENE names the scene (.json or .obj) of the picture that blocks of rays and Embree's packets race for;
// SHADOWLAB_THREADS says how many cores.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <functional>

#include "techniques/foundation/scene/load/load.h"
#include "techniques/foundation/scene/model/shapes.h"
#include "techniques/foundation/trace/bvh/bvh_traverse.h"
#include "techniques/foundation/trace/packets/embree_packets.h"
#include "techniques/foundation/trace/parallel.h"
#include "techniques/foundation/trace/scene_tracer.h"
#include "techniques/foundation/trace/structures/engine.h"
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

/// A floor and a ring of 64,000 triangles over it.
scene::Scene ringOverFloor() {
    scene::Scene scene = testing::floorScene();
    testing::addObject(scene, scene::makeTorus(0.7, 0.28, {250, 128}), testing::translation({0, 1.2, 0}));
    scene.objects[1].worldFromObject =
        scene.objects[1].worldFromObject * dmat4(dmat3(dvec3(1, 0, 0), dvec3(0, 0.6, 0.8), dvec3(0, -0.8, 0.6)));
    scene.lights.push_back(testing::pointLight({4, 6, 0}));
    scene.camera.targetWorld = {0, 0.9, 0};
    scene.camera.fovYDegrees = 45;
    return scene;
}

TEST(RayRate, OfAMeshOfSixtyThousandTriangles) {
    if (!std::getenv("SHADOWLAB_LONG")) GTEST_SKIP() << "a measurement; set SHADOWLAB_LONG=1";
    const scene::Scene scene = ringOverFloor();
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
    if (embree) embree->advance(Clock::time_point::max());
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

/// The eye rays of a camera, as Embree's packets take them.
PacketView packetView(const SceneTracer& tracer, const EyeRays& rays, ivec2 size) {
    const auto direction = [&](dvec2 pixel) { return rays.through(pixel).directionCentred; };
    const dvec3 corner = direction({0, 0});
    PacketView view;
    view.eye = vec3(rays.eyeCentred());
    view.corner = vec3(corner);
    view.perX = vec3((direction({size.x, 0}) - corner) / double(size.x));
    view.perY = vec3((direction({0, size.y}) - corner) / double(size.y));
    view.light = vec3(tracer.scene().lights[0].positionWorld - tracer.world().originWorld);
    view.width = size.x;
    return view;
}

// One eye ray for every pixel and one shadow ray from where it ends, for one point light: a whole shadow picture, by
// single rays, by blocks, by blocks that are told the triangles, and by Embree's packets of eight; turn by turn, so that
// whatever else the machine does falls on all alike.
TEST(RayRate, OfAShadowPictureByBlocksAndByPacketsOfEmbree) {
    if (!std::getenv("SHADOWLAB_LONG")) GTEST_SKIP() << "a measurement; set SHADOWLAB_LONG=1";
    const char* const given = std::getenv("SHADOWLAB_RATE_SCENE");
    const scene::Snapshot snapshot = given ? scene::loadScene(given, {}) : testing::snapshot(ringOverFloor());
    ASSERT_TRUE(!snapshot->lights.empty() && snapshot->lights[0].type == scene::LightType::point);
    SceneTracer tracer;
    tracer.advance(snapshot, Clock::time_point::max());
    const ivec2 size{1280, 720};
    constexpr int kSide = SceneTracer::kBlock;
    constexpr std::size_t kRows = 720 / kSide;
    const EyeRays rays = tracer.eyeRays(snapshot->camera, size);
    const auto count = static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y);
    std::vector<Visibility> alone(count), together(count), told(count);
    std::vector<std::uint32_t> primitives(count);
    std::vector<std::uint8_t> packets(count);

    const auto byBlocks = [&](std::vector<Visibility>& to, bool areTold) {
        parallelFor(kRows, [&](std::size_t row) {
            SurfacePoint points[kSide * kSide];
            Visibility answers[kSide * kSide];
            std::uint32_t receivers[kSide * kSide];
            for (int x = 0; x < size.x; x += kSide) {
                const ivec2 corner(x, static_cast<int>(row) * kSide);
                const auto place = [&](int i) {
                    return static_cast<std::size_t>((corner.y + i / kSide) * size.x + corner.x + i % kSide);
                };
                for (int i = 0; areTold && i < kSide * kSide; ++i)
                    receivers[i] = primitives[place(i)];
                if (areTold)
                    tracer.eyePointsOn(receivers, rays, corner, ivec2(kSide), dvec2(0.5), points);
                else
                    tracer.eyePoints(rays, corner, ivec2(kSide), dvec2(0.5), points);
                tracer.visibilities(points, 0, answers);
                for (int i = 0; i < kSide * kSide; ++i)
                    to[place(i)] = answers[i];
            }
        });
    };
    const auto byEmbree = makeEmbreePackets(tracer.world().triangles);
    const PacketView view = packetView(tracer, rays, size);
    const std::function<void()> ways[] = {
        [&] {
            parallelFor(720, [&](std::size_t y) {
                for (std::size_t x = 0; x < 1280; ++x) {
                    const SurfacePoint point = tracer.eyePoint(rays, dvec2(x, y) + 0.5);
                    primitives[y * 1280 + x] = point.primitive;
                    alone[y * 1280 + x] = tracer.visibility(point, 0);
                }
            });
        },
        [&] { byBlocks(together, false); },
        [&] { byBlocks(told, true); },
        [&] {
            if (byEmbree)
                parallelFor(720, [&](std::size_t y) { byEmbree->row(view, static_cast<int>(y), &packets[y * 1280]); });
        },
    };
    constexpr std::size_t kRounds = 31;
    std::vector<double> times[4];
    for (std::size_t round = 0; round < kRounds; ++round)
        for (std::size_t way = 0; way < 4; ++way) {
            const auto begin = Clock::now();
            ways[way]();
            times[way].push_back(std::chrono::duration<double, std::milli>(Clock::now() - begin).count());
        }
    for (std::vector<double>& ofWay : times)
        std::ranges::nth_element(ofWay, ofWay.begin() + kRounds / 2);
    const auto median = [&](int way) { return times[way][kRounds / 2]; };
    EXPECT_GT(std::ranges::count(alone, Visibility::shadowed), 1000);
    EXPECT_EQ(alone, together);
    EXPECT_EQ(alone, told);
    std::size_t differing = 0;
    for (std::size_t i = 0; i < count; ++i)
        differing += (packets[i] == 2) != (alone[i] == Visibility::lit);
    std::cout << triangleCount(*snapshot) << " triangles, " << size.x << " x " << size.y << ", " << threadCount()
              << " threads, kernels for " << bestBlockKernels().name << "; medians of " << kRounds << "\n"
              << "single rays             " << median(0) << " ms\n"
              << "blocks                  " << median(1) << " ms\n"
              << "blocks, triangles told  " << median(2) << " ms\n";
    if (byEmbree)
        std::cout << "Embree, packets of 8    " << median(3) << " ms; blocks take " << median(1) / median(3)
                  << " times as long, told " << median(2) / median(3) << "; it differs in " << differing << " pixels\n";
}

} // namespace
} // namespace shadowlab::trace
