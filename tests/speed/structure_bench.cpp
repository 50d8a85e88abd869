// What each structure costs and spares: time to build, memory, tests per ray, rays per second.
//
//   ninja -C build/release structure_bench && SHADOWLAB_THREADS=2 build/release/tests/structure_bench [FILE.obj...]
//
// Scenes of 10^2 to 10^6 triangles in 64 objects, which lie about in a ball; then the files. Three kinds of rays:
//   eye      512 x 512 of them, from one point, neighbours one after the other
//   shadow   from where those end to a point light; each ends at the first hit
//   random   from anywhere to anywhere in the scene's box
// One ray at a time, but for two rows: `bvh-64` is our tree asked in blocks of 64 rays, as ray tracing asks it
// (SceneTracer), `embree-8` Embree asked in its packets of eight, eye and shadow rays together in each case, so that their
// eye column holds rays of both kinds. All structures take turns, so that whatever else the machine does falls on all alike;
// medians of the rounds. Where a round of all rays would take longer than some seconds, rays are left out of it evenly; where
// it still would, the structure is. `of Embree`: rays per second, as a share of Embree's.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <map>
#include <random>
#include <string>
#include <vector>

#include "techniques/foundation/scene/load.h"
#include "techniques/foundation/trace/embree_packets.h"
#include "techniques/foundation/trace/parallel.h"
#include "techniques/foundation/trace/scene_tracer.h"
#include "tests/support/scenes.h"

namespace shadowlab {
namespace {

using namespace trace;
using Clock = std::chrono::steady_clock;

constexpr int kSide = 512, kRounds = 7;
constexpr std::size_t kRays = std::size_t{kSide} * kSide;
constexpr double kLongestMs = 400; // of one round of one structure and one kind of rays

double milliseconds(const auto& work) {
    const auto start = Clock::now();
    work();
    return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

double median(std::vector<double> values) {
    std::ranges::nth_element(values, values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2));
    return values[values.size() / 2];
}

/// 64 balls of small triangles, together so many.
scene::Scene generated(int triangles) {
    std::mt19937 random(1);
    std::normal_distribution<double> normal;
    const auto anywhere = [&] { return dvec3(normal(random), normal(random), normal(random)); };
    scene::Scene scene = testing::floorScene();
    scene.objects.clear();
    constexpr int kObjects = 64;
    const double size =
        6 / std::sqrt(triangles); // the smaller, the more there are: all scenes have about the same area
    for (int object = 0; object < kObjects; ++object) {
        const dvec3 middle = 2.0 * anywhere();
        std::vector<dvec3> corners;
        for (int i = object * triangles / kObjects; i < (object + 1) * triangles / kObjects; ++i) {
            const dvec3 place = middle + 0.3 * anywhere();
            for (int corner = 0; corner < 3; ++corner)
                corners.push_back(place + size * anywhere());
        }
        testing::addObject(scene, testing::triangleSoup(corners));
    }
    scene.camera.positionWorld = {0, 3, 9};
    scene.camera.targetWorld = {0, 0, 0};
    scene.lights = {testing::pointLight({8, 12, 6})};
    return scene;
}

struct Rays {
    std::vector<Ray> rays;
    std::vector<std::uint32_t> except; ///< shadow rays: the triangle each starts on
};

/// A structure, or a way to ask one, with what was measured.
struct Row {
    std::string name;
    std::unique_ptr<Engine> engine;
    double buildMs = 0;
    std::array<double, 3> testsPerRay{};
    std::array<std::size_t, 3> stride{1, 1, 1}; ///< every so many rays are sent; 0: none
    std::array<std::vector<double>, 3> megarays;
};

/// Every so many rays of one kind; returns how many there were.
std::size_t send(const Engine& engine, const Rays& rays, bool any, std::size_t stride) {
    constexpr std::size_t kPiece = 512;
    const std::size_t count = (rays.rays.size() + stride - 1) / stride;
    std::atomic<std::size_t> hits = 0;
    parallelFor((count + kPiece - 1) / kPiece, [&](std::size_t piece) {
        std::size_t found = 0;
        for (std::size_t i = piece * kPiece; i < std::min(count, (piece + 1) * kPiece); ++i) {
            const Ray& ray = rays.rays[i * stride];
            found +=
                any ? engine.any(ray, {.except = rays.except[i * stride]}) != kNoPrimitive : bool(engine.closest(ray));
        }
        hits += found;
    });
    return count;
}

double testsPerRay(const Engine& engine, const Rays& rays, bool any) {
    constexpr std::size_t kSampled = 400;
    const std::size_t stride = std::max<std::size_t>(1, rays.rays.size() / kSampled);
    RayTests tests;
    double count = 0;
    for (std::size_t i = 0; i < rays.rays.size(); i += stride, ++count)
        any ? void(engine.any(rays.rays[i], {.except = rays.except[i]}, tests))
            : void(engine.closest(rays.rays[i], {}, tests));
    return static_cast<double>(tests.all()) / count;
}

/// The whole picture and its shadows in blocks; returns how many rays that were.
std::size_t sendBlocks(const SceneTracer& tracer, const EyeRays& rays) {
    std::atomic<std::size_t> sent = 0;
    constexpr int kBlock = SceneTracer::kBlock;
    parallelFor(kSide / kBlock, [&](std::size_t row) {
        std::size_t count = 0;
        std::array<SurfacePoint, kBlock * kBlock> points;
        std::array<Visibility, kBlock * kBlock> answers;
        for (int x = 0; x < kSide; x += kBlock) {
            tracer.eyePoints(rays, {x, static_cast<int>(row) * kBlock}, ivec2(kBlock), dvec2(0.5), points);
            tracer.visibilities(points, 0, answers);
            count += points.size();
            for (const Visibility answer : answers)
                count += answer == Visibility::lit || answer == Visibility::shadowed;
        }
        sent += count;
    });
    return sent;
}

PacketView packetView(const SceneTracer& tracer, const EyeRays& rays) {
    const auto direction = [&](dvec2 pixel) { return rays.through(pixel).directionCentred; };
    const dvec3 corner = direction({0, 0}), light = tracer.scene().lights[0].positionWorld;
    return {.eye = vec3(rays.eyeCentred()),
            .corner = vec3(corner),
            .perX = vec3((direction({kSide, 0}) - corner) / double(kSide)),
            .perY = vec3((direction({0, kSide}) - corner) / double(kSide)),
            .light = vec3(light - tracer.world().originWorld),
            .width = kSide};
}

/// One ray to the light from every hit: Embree's packets send them from both sides of a triangle.
std::size_t sendPackets(const EmbreePackets& packets, const PacketView& view) {
    std::atomic<std::size_t> sent = 0;
    parallelFor(kSide, [&](std::size_t y) {
        std::array<std::uint8_t, kSide> mask{};
        packets.row(view, static_cast<int>(y), mask.data());
        sent += mask.size() + static_cast<std::size_t>(std::ranges::count_if(mask, [](int m) { return m != 0; }));
    });
    return sent;
}

std::array<Rays, 3> raysOf(const SceneTracer& tracer, const EyeRays& eyeRays) {
    std::array<Rays, 3> all;
    const dvec3 light = tracer.scene().lights[0].positionWorld - tracer.world().originWorld;
    scene::Bounds bounds;
    for (const Triangle& t : tracer.world().triangles)
        for (const dvec3* corner : {&t.a, &t.b, &t.c})
            bounds.include(*corner);
    std::mt19937 random(2);
    const auto anywhere = [&] {
        std::uniform_real_distribution<double> share;
        const double x = share(random), y = share(random);
        return glm::mix(bounds.lowerWorld, bounds.upperWorld, dvec3(x, y, share(random)));
    };
    for (int y = 0; y < kSide; ++y)
        for (int x = 0; x < kSide; ++x) {
            all[0].rays.push_back(eyeRays.through(dvec2(x, y) + 0.5));
            const SurfacePoint point = tracer.eyePoint(eyeRays, dvec2(x, y) + 0.5);
            if (point && tracer.facesLight(point, 0)) {
                const dvec3 from = tracer.positionCentred(point);
                // Ends are as far off as float needs them, for Embree.
                all[1].rays.push_back({from, light - from, 1e-4, 1});
                all[1].except.push_back(point.primitive);
            }
            const dvec3 from = anywhere();
            all[2].rays.push_back({from, anywhere() - from});
        }
    // Where few points face the light, their rays are sent again, so that as many are timed.
    for (std::size_t i = 0; !all[1].rays.empty() && all[1].rays.size() < kRays; ++i) {
        all[1].rays.push_back(all[1].rays[i]);
        all[1].except.push_back(all[1].except[i]);
    }
    return all;
}

void measure(const std::string& title, const scene::Snapshot& snapshot) {
    SceneTracer tracer;
    tracer.advance(snapshot, Engine::Deadline::max());
    const EyeRays eyeRays = tracer.eyeRays(snapshot->camera, ivec2(kSide));
    const std::array<Rays, 3> rays = raysOf(tracer, eyeRays);
    const EngineInput input{tracer.world().triangles, tracer.world().firstOfObject};
    std::printf("\n%s: %zu triangles, %zu objects\n", title.c_str(), input.triangles.size(),
                input.firstOfObject.size());

    std::vector<Row> rows;
    const char* const names[] = {"none", "object-spheres", "object-boxes", "groups", "sphere-tree",
                                 "bvh",  "grid",           "embree"};
    for (int i = 0; i < kStructureCount; ++i) {
        Row row{.name = names[i], .engine = nullptr, .megarays = {}};
        std::vector<double> buildMs;
        for (int round = 0; round < 3; ++round) {
            buildMs.push_back(milliseconds([&] {
                row.engine = i == static_cast<int>(Structure::embree) ? makeEmbreeEngine(input.triangles)
                                                                      : makeEngine(static_cast<Structure>(i), input);
                if (row.engine) row.engine->advance(Engine::Deadline::max());
            }));
        }
        if (!row.engine) continue;
        row.buildMs = median(buildMs);
        for (std::size_t kind = 0; kind < 3; ++kind) {
            // A few rays tell how many can be sent in the time.
            const std::size_t few = std::max<std::size_t>(1, rays[kind].rays.size() / 64);
            std::size_t sent = 0;
            const double ms = milliseconds([&] { sent = send(*row.engine, rays[kind], kind == 1, few); });
            const double allMs = ms / static_cast<double>(sent) * static_cast<double>(rays[kind].rays.size());
            const auto stride = static_cast<std::size_t>(std::max(1.0, std::ceil(allMs / kLongestMs)));
            row.stride[kind] = stride > few ? 0 : stride;
            if (row.stride[kind]) row.testsPerRay[kind] = testsPerRay(*row.engine, rays[kind], kind == 1);
        }
        rows.push_back(std::move(row));
    }
    const auto packets = makeEmbreePackets(tracer.world().triangles);
    Row blocksRow{.name = "bvh-64", .engine = nullptr, .megarays = {}};
    Row packetsRow{.name = "embree-8", .engine = nullptr, .megarays = {}};
    const auto rate = [](std::size_t sent, double ms) { return static_cast<double>(sent) / ms / 1000; };
    for (int round = 0; round < kRounds; ++round) {
        std::size_t sent = 0;
        for (std::size_t kind = 0; kind < 3; ++kind)
            for (Row& row : rows) {
                if (row.stride[kind] == 0) continue;
                const double ms =
                    milliseconds([&] { sent = send(*row.engine, rays[kind], kind == 1, row.stride[kind]); });
                row.megarays[kind].push_back(rate(sent, ms));
            }
        double ms = milliseconds([&] { sent = sendBlocks(tracer, eyeRays); });
        blocksRow.megarays[0].push_back(rate(sent, ms));
        if (!packets) continue;
        const PacketView view = packetView(tracer, eyeRays);
        ms = milliseconds([&] { sent = sendPackets(*packets, view); });
        packetsRow.megarays[0].push_back(rate(sent, ms));
    }
    rows.push_back(std::move(blocksRow));
    if (packets) rows.push_back(std::move(packetsRow));

    std::map<std::string, std::array<double, 3>> medians;
    for (const Row& row : rows)
        for (std::size_t kind = 0; kind < 3; ++kind)
            medians[row.name][kind] = row.megarays[kind].empty() ? 0 : median(row.megarays[kind]);
    std::printf("| %-14s | %9s | %8s | %-26s | %-23s | %-17s |\n", "structure", "build ms", "MiB",
                "tests: eye, shadow, random", "Mray/s: eye, sh., rnd.", "of Embree");
    for (const Row& row : rows) {
        const auto& mine = medians[row.name];
        const auto& embree = medians[row.name == "bvh-64" ? "embree-8" : "embree"];
        std::array<double, 3> share{};
        for (std::size_t kind = 0; kind < 3; ++kind)
            share[kind] = embree[kind] > 0 ? mine[kind] / embree[kind] : 0;
        std::printf("| %-14s | %9.2f | %8.2f | %8.1f %8.1f %8.1f | %7.3f %7.3f %7.3f | %5.2f %5.2f %5.2f |\n",
                    row.name.c_str(), row.buildMs,
                    row.engine ? static_cast<double>(row.engine->bytes()) / (1 << 20) : 0.0, row.testsPerRay[0],
                    row.testsPerRay[1], row.testsPerRay[2], mine[0], mine[1], mine[2], share[0], share[1], share[2]);
    }
    std::fflush(stdout);
}

} // namespace
} // namespace shadowlab

int main(int count, char** arguments) {
    using namespace shadowlab;
    std::printf("%d x %d eye rays, medians of %d rounds, %d threads; 0: not measured\n", kSide, kSide, kRounds,
                trace::threadCount());
    for (const int triangles : {100, 1000, 10'000, 100'000, 1'000'000})
        measure("generated", testing::snapshot(generated(triangles)));
    for (int i = 1; i < count; ++i)
        measure(arguments[i], scene::loadScene(arguments[i], {.assetsRoot = {}, .allowed = {}, .limits = {}}));
}
