// The tree that rays are asked of: building it, and rays of three kinds, by triangles; the exact predicate, by rays.
// SPDX-License-Identifier: MIT
#include <benchmark/benchmark.h>

#include <chrono>
#include <random>

#include "techniques/foundation/trace/engine.h"
#include "techniques/foundation/trace/exact_sign.h"
#include "techniques/foundation/trace/world_triangles.h"
#include "tests/speed/hot_paths/meshes.h"

namespace shadowlab {
namespace {

constexpr std::int64_t kFewest = 1 << 10, kMost = 1 << 18;
constexpr std::size_t kRays = 4096;

/// A knot's triangles and the tree over them.
struct Tree {
    trace::WorldTriangles world;
    std::unique_ptr<trace::Engine> engine;
    explicit Tree(std::int64_t triangles) : world(trace::worldTriangles(speed::knotScene(triangles))) { build(); }
    void build() {
        engine = trace::makeEngine(trace::Structure::bvh, {world.triangles, {}});
        while (!engine->advance(std::chrono::steady_clock::time_point::max())) {
        }
    }
};

void treeBuilding(benchmark::State& state) {
    Tree tree(state.range(0));
    for (auto _ : state)
        tree.build();
    state.SetComplexityN(static_cast<std::int64_t>(tree.world.triangles.size()));
}
BENCHMARK(treeBuilding)
    ->RangeMultiplier(4)
    ->Range(kFewest, kMost)
    ->Unit(benchmark::kMillisecond)
    ->Complexity(benchmark::oNLogN);

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
void rays(benchmark::State& state, Kind kind) {
    const Tree tree(state.range(0));
    const std::vector<trace::Ray> rays = raysOf(kind);
    for (auto _ : state)
        for (const trace::Ray& ray : rays) {
            if (kind == towardTheLight)
                benchmark::DoNotOptimize(tree.engine->any(ray));
            else
                benchmark::DoNotOptimize(tree.engine->closest(ray));
        }
    state.SetItemsProcessed(static_cast<std::int64_t>(state.iterations() * kRays));
    state.SetComplexityN(static_cast<std::int64_t>(tree.world.triangles.size()));
}
BENCHMARK_CAPTURE(rays, fromTheEye, fromTheEye)
    ->RangeMultiplier(4)
    ->Range(kFewest, kMost)
    ->Complexity(benchmark::oLogN);
BENCHMARK_CAPTURE(rays, towardTheLight, towardTheLight)
    ->RangeMultiplier(4)
    ->Range(kFewest, kMost)
    ->Complexity(benchmark::oLogN);
BENCHMARK_CAPTURE(rays, anywhere, anywhere)->RangeMultiplier(4)->Range(kFewest, kMost)->Complexity(benchmark::oLogN);

/// The sign that says on which side of an edge a ray passes, where double leaves it open: the three vectors lie in one plane.
void exactPredicate(benchmark::State& state) {
    std::mt19937 random(2);
    std::uniform_real_distribution<double> real(-3, 3);
    std::vector<dvec3> points;
    for (std::int64_t i = 0; i < 3 * state.range(0); ++i)
        points.emplace_back(real(random), real(random), real(random));
    for (auto _ : state)
        for (std::size_t i = 0; i + 2 < points.size(); i += 3)
            benchmark::DoNotOptimize(
                trace::exactTripleSign(points[i + 1] - points[i], points[i], points[i + 1], points[i + 2]));
    state.SetComplexityN(state.range(0));
}
BENCHMARK(exactPredicate)->RangeMultiplier(4)->Range(1 << 8, 1 << 14)->Complexity(benchmark::oN);

} // namespace
} // namespace shadowlab
