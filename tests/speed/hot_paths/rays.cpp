// The structures that rays are asked of, a tree and a grid: building them, and rays of three kinds, by triangles; the sign that decides
// whether a ray hits, by how close it comes to an edge.
// SPDX-License-Identifier: MIT
#include <benchmark/benchmark.h>

#include <chrono>
#include <cmath>
#include <limits>
#include <random>
#include <string>

#include "techniques/foundation/trace/ray_triangle.h"
#include "techniques/foundation/trace/structures/engine.h"
#include "techniques/foundation/trace/world_triangles.h"
#include "tests/speed/hot_paths/meshes.h"

namespace shadowlab {
namespace {

constexpr std::int64_t kFewest = 1 << 10, kMost = 1 << 18;
constexpr std::size_t kRays = 4096;

/// A knot's triangles and a structure over them.
struct Structured {
    trace::WorldTriangles world;
    trace::Structure structure;
    std::unique_ptr<trace::Engine> engine;
    Structured(trace::Structure kind, std::int64_t triangles)
        : world(trace::worldTriangles(speed::knotScene(triangles))), structure(kind) {
        build();
    }
    void build() {
        engine = trace::makeEngine(structure, {world.triangles, {}});
        while (!engine->advance(std::chrono::steady_clock::time_point::max())) {
        }
    }
};

void building(benchmark::State& state, trace::Structure structure) {
    Structured structured(structure, state.range(0));
    for (auto _ : state)
        structured.build();
    state.SetComplexityN(static_cast<std::int64_t>(structured.world.triangles.size()));
}
BENCHMARK_CAPTURE(building, tree, trace::Structure::bvh)
    ->RangeMultiplier(4)
    ->Range(kFewest, kMost)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime() // on all cores
    ->Complexity(benchmark::oNLogN);
// As many cells as triangles, about, and each triangle is put into a few.
BENCHMARK_CAPTURE(building, grid, trace::Structure::grid)
    ->RangeMultiplier(4)
    ->Range(kFewest, kMost)
    ->Unit(benchmark::kMillisecond)
    ->Complexity(benchmark::oN);

enum Kind { fromTheEye, towardTheLight, anywhere };

std::vector<trace::Ray> raysOf(Kind kind) {
    std::mt19937 random(1);
    std::uniform_real_distribution<double> real(-3, 3);
    std::vector<trace::Ray> rays;
    for (std::size_t i = 0; i < kRays; ++i) {
        const dvec3 place(0.09 * static_cast<double>(i % 64) - 2.9, 0.09 * static_cast<double>(i / 64) - 2.9, 0);
        const dvec3 chance(real(random), real(random), real(random)), other(real(random), real(random), real(random));
        const dvec3 origin = kind == fromTheEye ? dvec3(0, 3, 11) : kind == towardTheLight ? place : chance;
        const dvec3 target = kind == fromTheEye ? place : kind == towardTheLight ? dvec3(4, 9, 3) : other;
        rays.push_back({.originCentred = origin, .directionCentred = target - origin});
    }
    return rays;
}

/// Of 4096 rays each: the nearest hit, or for shadow rays whether there is any.
void rays(benchmark::State& state, trace::Structure structure, Kind kind) {
    const Structured structured(structure, state.range(0));
    const std::vector<trace::Ray> rays = raysOf(kind);
    for (auto _ : state)
        for (const trace::Ray& ray : rays) {
            if (kind == towardTheLight)
                benchmark::DoNotOptimize(structured.engine->any(ray));
            else
                benchmark::DoNotOptimize(structured.engine->closest(ray));
        }
    state.SetItemsProcessed(static_cast<std::int64_t>(state.iterations() * kRays));
    state.SetComplexityN(static_cast<std::int64_t>(structured.world.triangles.size()));
}

/// Cells that a ray passes on its way through a grid: as many as there are along an edge of it.
double cellsAlongEdge(benchmark::IterationCount triangles) { return std::cbrt(static_cast<double>(triangles)); }

const int registered = [] {
    static constexpr std::pair<const char*, Kind> kinds[] = {
        {"fromTheEye", fromTheEye}, {"towardTheLight", towardTheLight}, {"anywhere", anywhere}};
    for (const auto& [name, kind] : kinds) {
        // Down a tree: its depth.
        benchmark::RegisterBenchmark((std::string("rays/tree/") + name).c_str(), rays, trace::Structure::bvh, kind)
            ->RangeMultiplier(4)
            ->Range(kFewest, kMost)
            ->Complexity(benchmark::oLogN);
        benchmark::RegisterBenchmark((std::string("rays/grid/") + name).c_str(), rays, trace::Structure::grid, kind)
            ->RangeMultiplier(4)
            ->Range(kFewest, kMost)
            ->Complexity(cellsAlongEdge);
    }
    return 0;
}();

/// How the sign is found that says on which side of an edge a ray passes.
enum class Digits {
    ofDouble, ///< the ray passes far from the edge, which one comparison tells: nearly all
    twice,    ///< closer than double can tell; here always, as the bound is said to be infinite
    all,      ///< the three vectors lie in one plane
};

void sign(benchmark::State& state, Digits digits) {
    std::mt19937 random(2);
    std::uniform_real_distribution<double> real(-3, 3);
    std::vector<dvec3> points;
    for (std::int64_t i = 0; i < 4 * state.range(0); ++i)
        points.emplace_back(real(random), real(random), real(random));
    const double bound = digits == Digits::ofDouble ? 0 : std::numeric_limits<double>::infinity();
    for (auto _ : state)
        for (std::size_t i = 0; i + 3 < points.size(); i += 4) {
            const dvec3 direction = digits == Digits::all ? points[i + 1] - points[i] : points[i + 3];
            const trace::ShearedRay ray({.originCentred = points[i], .directionCentred = direction});
            benchmark::DoNotOptimize(trace::certainSide(points[i].x, bound, ray, points[i + 1], points[i + 2]));
        }
    state.SetComplexityN(state.range(0));
}
BENCHMARK_CAPTURE(sign, ofDouble, Digits::ofDouble)
    ->RangeMultiplier(4)
    ->Range(1 << 8, 1 << 14)
    ->Complexity(benchmark::oN);
BENCHMARK_CAPTURE(sign, twiceTheDigits, Digits::twice)
    ->RangeMultiplier(4)
    ->Range(1 << 8, 1 << 14)
    ->Complexity(benchmark::oN);
BENCHMARK_CAPTURE(sign, allDigits, Digits::all)->RangeMultiplier(4)->Range(1 << 8, 1 << 14)->Complexity(benchmark::oN);

} // namespace
} // namespace shadowlab
