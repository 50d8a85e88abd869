// What each structure costs and spares: time to build, memory, tests per ray, rays per second.
//
//   ninja -C build/release structure_bench
//   SHADOWLAB_THREADS=2 build/release/tests/structure_bench [--only NAME,...] [--plot OUT.svg] [COUNT | FILE.obj]...
//
// Scenes of COUNT triangles in 64 objects, which lie about in a ball, and files; without any, 10^2 to 10^6 triangles. Three
// kinds of rays:
//   eye      512 x 512 of them, from one point, neighbours one after the other
//   shadow   from where those end to a point light; each ends at the first hit
//   random   from anywhere to anywhere in the scene's box
// One ray at a time, but for two rows: `bvh-64` is our tree asked in blocks of 64 rays, as ray tracing asks it
// (SceneTracer), `embree-8` Embree asked in its packets of eight, eye and shadow rays together in each case, so that their
// eye column holds rays of both kinds. All structures take turns; times of rays are the processor's, of all threads together
// divided by their number, so that what else the machine does counts for nothing; medians of the rounds. Building is timed by
// the clock, with all threads, and the best of the rounds counts: part of it waits for one thread. Rays are left out evenly
// where a round would take long; `none` sends a handful through a million triangles. `of Embree`: rays per second, as a share
// of Embree's in the same round, and the median of that.
//
// --plot draws the time of an eye ray against the number of triangles; slopes of such lines are printed in any case.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <fstream>
#include <random>
#include <string>
#include <vector>

#include "techniques/foundation/scene/load/load.h"
#include "techniques/foundation/trace/packets/embree_packets.h"
#include "techniques/foundation/trace/parallel.h"
#include "techniques/foundation/trace/scene_tracer.h"
#include "tests/speed/line_plot.h"
#include "tests/speed/median.h"
#include "tests/support/scenes.h"

namespace shadowlab {
namespace {

using namespace trace;
using Clock = std::chrono::steady_clock;

constexpr int kSide = 512, kRounds = 5, kBuildRounds = 3;
constexpr std::size_t kRays = std::size_t{kSide} * kSide;
constexpr double kLongestMs = 150; // of one round of one structure and one kind of rays

double clockMs(const auto& work) {
    const auto start = Clock::now();
    work();
    return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

/// As if every thread had a processor for itself.
double processorMs(const auto& work) {
    const std::clock_t start = std::clock();
    work();
    return 1000.0 * static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC / threadCount();
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
    std::array<std::size_t, 3> stride{1, 1, 1};  ///< every so many rays are sent
    std::array<std::vector<double>, 3> megarays; ///< per second, of each round

    [[nodiscard]] double rate(std::size_t kind) const { return megarays[kind].empty() ? 0 : median(megarays[kind]); }
    [[nodiscard]] double share(const Row* of, std::size_t kind) const {
        if (!of || megarays[kind].empty()) return 0;
        std::vector<double> shares;
        for (std::size_t round = 0; round < megarays[kind].size(); ++round)
            shares.push_back(megarays[kind][round] / of->megarays[kind][round]);
        return median(shares);
    }
};

/// Every so many rays of one kind; returns how many there were.
std::size_t send(const Engine& engine, const Rays& rays, bool any, std::size_t stride) {
    const std::size_t count = (rays.rays.size() + stride - 1) / stride;
    const std::size_t perPiece = std::clamp<std::size_t>(count / 16, 1, 512);
    std::atomic<std::size_t> hits = 0;
    parallelFor((count + perPiece - 1) / perPiece, [&](std::size_t piece) {
        std::size_t found = 0;
        for (std::size_t i = piece * perPiece; i < std::min(count, (piece + 1) * perPiece); ++i) {
            const Ray& ray = rays.rays[i * stride];
            found +=
                any ? engine.any(ray, {.except = rays.except[i * stride]}) != kNoPrimitive : bool(engine.closest(ray));
        }
        hits += found;
    });
    return count;
}

double testsPerRay(const Engine& engine, const Rays& rays, bool any, std::size_t stride) {
    constexpr std::size_t kSampled = 400;
    stride = std::max(stride, rays.rays.size() / kSampled);
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

/// How many rays to leave out, found with few rays, then more.
std::size_t strideFor(const Engine& engine, const Rays& rays, bool any) {
    const double count = static_cast<double>(rays.rays.size());
    for (std::size_t stride = std::max<std::size_t>(1, rays.rays.size() / 16);; stride = (stride + 15) / 16) {
        std::size_t sent = 0;
        const double ms = processorMs([&] { sent = send(engine, rays, any, stride); });
        const double allMs = ms / static_cast<double>(sent) * count;
        if (ms * 16 > kLongestMs || stride == 1)
            return static_cast<std::size_t>(std::max(1.0, std::ceil(allMs / kLongestMs)));
    }
}

constexpr const char* kNames[] = {"none", "object-spheres", "object-boxes", "groups", "sphere-tree",
                                  "bvh",  "grid",           "embree"};

std::vector<Row> measure(const std::string& title, const scene::Snapshot& snapshot,
                         const std::vector<std::string>& only) {
    SceneTracer tracer;
    tracer.advance(snapshot, Engine::Deadline::max());
    const EyeRays eyeRays = tracer.eyeRays(snapshot->camera, ivec2(kSide));
    const std::array<Rays, 3> rays = raysOf(tracer, eyeRays);
    const EngineInput input{tracer.world().triangles, tracer.world().firstOfObject};
    std::printf("\n%s: %zu triangles, %zu objects\n", title.c_str(), input.triangles.size(),
                input.firstOfObject.size());

    std::vector<Row> rows;
    for (int i = 0; i < kStructureCount; ++i)
        if (only.empty() || std::ranges::count(only, kNames[i]) != 0)
            rows.push_back({.name = kNames[i], .engine = nullptr, .megarays = {}});
    const auto structureOf = [](const Row& row) {
        return static_cast<Structure>(std::ranges::find(kNames, row.name) - std::begin(kNames));
    };
    for (int round = 0; round < kBuildRounds; ++round)
        for (Row& row : rows) {
            row.engine.reset();
            const double ms = clockMs([&] {
                row.engine = structureOf(row) == Structure::embree ? makeEmbreeEngine(input.triangles)
                                                                   : makeEngine(structureOf(row), input);
                if (row.engine) row.engine->advance(Engine::Deadline::max());
            });
            row.buildMs = round == 0 ? ms : std::min(row.buildMs, ms);
        }
    std::erase_if(rows, [](const Row& row) { return !row.engine; });
    for (Row& row : rows)
        for (std::size_t kind = 0; kind < 3; ++kind) {
            row.stride[kind] = strideFor(*row.engine, rays[kind], kind == 1);
            row.testsPerRay[kind] = testsPerRay(*row.engine, rays[kind], kind == 1, row.stride[kind]);
        }
    const auto packets = makeEmbreePackets(tracer.world().triangles);
    Row blocksRow{.name = "bvh-64", .engine = nullptr, .megarays = {}};
    Row packetsRow{.name = "embree-8", .engine = nullptr, .megarays = {}};
    const auto rate = [](std::size_t sent, double ms) { return static_cast<double>(sent) / ms / 1000; };
    for (int round = 0; round < kRounds; ++round) {
        std::size_t sent = 0;
        for (std::size_t kind = 0; kind < 3; ++kind)
            for (Row& row : rows) {
                const double ms =
                    processorMs([&] { sent = send(*row.engine, rays[kind], kind == 1, row.stride[kind]); });
                row.megarays[kind].push_back(rate(sent, ms));
            }
        double ms = processorMs([&] { sent = sendBlocks(tracer, eyeRays); });
        blocksRow.megarays[0].push_back(rate(sent, ms));
        if (!packets) continue;
        const PacketView view = packetView(tracer, eyeRays);
        ms = processorMs([&] { sent = sendPackets(*packets, view); });
        packetsRow.megarays[0].push_back(rate(sent, ms));
    }
    rows.push_back(std::move(blocksRow));
    if (packets) rows.push_back(std::move(packetsRow));

    const auto rowOf = [&](const char* name) -> const Row* {
        const auto found = std::ranges::find(rows, name, &Row::name);
        return found == rows.end() ? nullptr : &*found;
    };
    std::printf("| %-14s | %9s | %8s | %-29s | %-26s | %-17s |\n", "structure", "build ms", "MiB",
                "tests: eye, shadow, random", "Mray/s: eye, sh., rnd.", "of Embree");
    for (const Row& row : rows) {
        const Row* const embree = rowOf(row.name == "bvh-64" || row.name == "embree-8" ? "embree-8" : "embree");
        std::printf("| %-14s | %9.2f | %8.2f | %9.1f %9.1f %9.1f | %8.3g %8.3g %8.3g | %5.2f %5.2f %5.2f |\n",
                    row.name.c_str(), row.buildMs,
                    row.engine ? static_cast<double>(row.engine->bytes()) / (1 << 20) : 0.0, row.testsPerRay[0],
                    row.testsPerRay[1], row.testsPerRay[2], row.rate(0), row.rate(1), row.rate(2), row.share(embree, 0),
                    row.share(embree, 1), row.share(embree, 2));
    }
    std::fflush(stdout);
    return rows;
}

/// Slope of the straight line through points, both coordinates by powers of ten: 1 for what grows as the number does.
double slope(const std::vector<double>& x, const std::vector<double>& y) {
    double meanX = 0, meanY = 0, xy = 0, xx = 0;
    for (std::size_t i = 0; i < x.size(); ++i) {
        meanX += std::log10(x[i]) / static_cast<double>(x.size());
        meanY += std::log10(y[i]) / static_cast<double>(x.size());
    }
    for (std::size_t i = 0; i < x.size(); ++i) {
        xy += (std::log10(x[i]) - meanX) * (std::log10(y[i]) - meanY);
        xx += (std::log10(x[i]) - meanX) * (std::log10(x[i]) - meanX);
    }
    return xy / xx;
}

/// Of the generated scenes, each with its rows: the same structures in all.
void showGrowth(const std::vector<double>& triangles, const std::vector<std::vector<Row>>& scenes,
                const std::string& plotPath) {
    // Okabe and Ito's colours, which survive colour blindness, without the yellow that white paper swallows.
    const std::pair<const char*, const char*> colors[] = {
        {"none", "#000000"},        {"object-spheres", "#e69f00"}, {"object-boxes", "#56b4e9"}, {"groups", "#009e73"},
        {"sphere-tree", "#cc79a7"}, {"grid", "#0072b2"},           {"bvh", "#d55e00"},          {"embree", "#777777"}};
    Plot plot{.xLabel = "triangles",
              .yLabel = "microseconds per eye ray, two threads",
              .x = triangles,
              .xByPowersOfTwo = true,
              .xMarks = triangles,
              .firstPower = -2,
              .lastPower = 5,
              .lines = {}};
    std::printf("\nslope of the time of an eye ray, and of its tests, against the number of triangles\n");
    for (const auto& [name, color] : colors) {
        std::vector<double> microseconds, tests;
        for (const std::vector<Row>& rows : scenes)
            for (const Row& row : rows)
                if (row.name == name) {
                    microseconds.push_back(1 / row.rate(0));
                    tests.push_back(std::max(1.0, row.testsPerRay[0]));
                }
        if (microseconds.size() != triangles.size()) continue;
        std::printf("| %-14s | %5.2f | %5.2f |\n", name, slope(triangles, microseconds), slope(triangles, tests));
        plot.lines.push_back({name, color, microseconds});
    }
    std::ranges::stable_sort(plot.lines, std::ranges::greater{}, [](const PlotLine& line) { return line.y.back(); });
    if (!plotPath.empty()) std::ofstream(plotPath) << linePlot(plot);
}

std::vector<std::string> namesIn(const std::string& list) {
    std::vector<std::string> names(1);
    for (const char c : list)
        c == ',' ? void(names.emplace_back()) : names.back().push_back(c);
    return names;
}

} // namespace
} // namespace shadowlab

int main(int count, char** arguments) {
    using namespace shadowlab;
    std::vector<std::string> only, wanted(arguments + 1, arguments + count);
    std::string plotPath;
    for (auto at = wanted.begin(); at != wanted.end();) {
        const bool isOnly = *at == "--only", isPlot = *at == "--plot";
        if (!isOnly && !isPlot) {
            ++at;
            continue;
        }
        if (at + 1 == wanted.end()) return std::fprintf(stderr, "structure_bench: %s wants a value\n", at->c_str()), 2;
        isOnly ? void(only = namesIn(at[1])) : void(plotPath = at[1]);
        at = wanted.erase(at, at + 2);
    }
    if (wanted.empty()) wanted = {"100", "1000", "10000", "100000", "1000000"};
    std::printf("%d x %d eye rays, medians of %d rounds, %d threads\n", kSide, kSide, kRounds, trace::threadCount());
    std::vector<double> sizes;
    std::vector<std::vector<Row>> scenes;
    for (const std::string& one : wanted) {
        if (one.find_first_not_of("0123456789") == std::string::npos) {
            const int triangles = std::stoi(one);
            scenes.push_back(measure("generated", testing::snapshot(generated(triangles)), only));
            sizes.push_back(triangles);
        } else {
            measure(one, scene::loadScene(one, {.assetsRoot = {}, .allowed = {}, .limits = {}}), only);
        }
    }
    if (sizes.size() > 1) showGrowth(sizes, scenes, plotPath);
}
