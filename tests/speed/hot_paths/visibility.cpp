// What points see of a light: by rays, as a share of its area, by the alias-free map, and by the judge that tries every triangle.
// SPDX-License-Identifier: MIT
#include <benchmark/benchmark.h>

#include <chrono>

#include "techniques/foundation/trace/area/area_visibility.h"
#include "techniques/foundation/trace/judge/exact_visibility.h"
#include "techniques/shadow_map/irregular/alias_free.h"
#include "tests/speed/hot_paths/meshes.h"

namespace shadowlab {
namespace {

/// A knot's tracer, and where the eye rays of a picture end.
struct Seen {
    trace::SceneTracer tracer;
    std::vector<trace::SurfacePoint> points;

    Seen(const scene::Scene& scene, ivec2 size) {
        tracer.advance(testing::snapshot(scene), std::chrono::steady_clock::time_point::max());
        points.resize(static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y));
        tracer.eyePoints(tracer.eyeRays(scene.camera, size), ivec2(0), size, dvec2(0.5), points);
    }
};

constexpr ivec2 kSize{160, 90};
ivec2 sizeOf(std::int64_t width) { return {static_cast<int>(width), static_cast<int>(width) * 9 / 16}; }

scene::Scene lampScene(std::int64_t triangles) {
    scene::Scene scene = speed::knotScene(triangles);
    scene.lights[0].type = scene::LightType::rect;
    scene.lights[0].edgeUWorld = {1, 0, 0};
    scene.lights[0].edgeVWorld = {0, 0, 1}; // u x v: it shines downward
    return scene;
}

void shadowRays(benchmark::State& state, const Seen& seen) {
    std::vector<trace::Visibility> answers(seen.points.size());
    for (auto _ : state) {
        seen.tracer.visibilities(seen.points, 0, answers);
        benchmark::DoNotOptimize(answers.data());
    }
}
void exactVisibilityByPixels(benchmark::State& state) {
    const Seen seen(speed::knotScene(1 << 12), sizeOf(state.range(0)));
    shadowRays(state, seen);
    state.SetComplexityN(static_cast<std::int64_t>(seen.points.size()));
}
void exactVisibilityByTriangles(benchmark::State& state) {
    const Seen seen(speed::knotScene(state.range(0)), kSize);
    shadowRays(state, seen);
    state.SetComplexityN(state.range(0));
}
BENCHMARK(exactVisibilityByPixels)
    ->RangeMultiplier(2)
    ->Range(80, 640)
    ->Unit(benchmark::kMillisecond)
    ->Complexity(benchmark::oN);
// Down a tree: its depth.
BENCHMARK(exactVisibilityByTriangles)
    ->RangeMultiplier(4)
    ->Range(1 << 10, 1 << 18)
    ->Unit(benchmark::kMillisecond)
    ->Complexity(benchmark::oLogN);

void areaShares(benchmark::State& state, const Seen& seen) {
    const trace::AreaVisibility area(seen.tracer, 0);
    std::vector<trace::AreaShare> answers(seen.points.size());
    constexpr std::size_t kTogether = 256; // neighbours are asked together, as techniques do
    for (auto _ : state) {
        for (std::size_t first = 0; first < seen.points.size(); first += kTogether) {
            const std::size_t count = std::min(kTogether, seen.points.size() - first);
            area.shares(std::span(seen.points).subspan(first, count), {}, std::span(answers).subspan(first, count));
        }
        benchmark::DoNotOptimize(answers.data());
    }
}
void areaVisibilityByPixels(benchmark::State& state) {
    const Seen seen(lampScene(1 << 10), sizeOf(state.range(0)));
    areaShares(state, seen);
    state.SetComplexityN(static_cast<std::int64_t>(seen.points.size()));
}
void areaVisibilityByTriangles(benchmark::State& state) {
    const Seen seen(lampScene(state.range(0)), sizeOf(40));
    areaShares(state, seen);
    state.SetComplexityN(state.range(0));
}
BENCHMARK(areaVisibilityByPixels)
    ->RangeMultiplier(2)
    ->Range(40, 160)
    ->Unit(benchmark::kMillisecond)
    ->Complexity(benchmark::oN);
// From a point in the penumbra a share of all triangles stands before the light, and what each covers is cut out of it.
BENCHMARK(areaVisibilityByTriangles)
    ->RangeMultiplier(4)
    ->Range(1 << 8, 1 << 12)
    ->Unit(benchmark::kMillisecond)
    ->Complexity(benchmark::oN);

void aliasFree(benchmark::State& state, const Seen& seen) {
    std::vector<trace::Visibility> answers(seen.points.size());
    for (auto _ : state) {
        shadow_map::aliasFreeVisibilities(seen.tracer, seen.points, 0, answers, nullptr, 1);
        benchmark::DoNotOptimize(answers.data());
    }
}
void aliasFreeByPixels(benchmark::State& state) {
    const Seen seen(speed::knotScene(1 << 12), sizeOf(state.range(0)));
    aliasFree(state, seen);
    state.SetComplexityN(static_cast<std::int64_t>(seen.points.size()));
}
void aliasFreeByTriangles(benchmark::State& state) {
    const Seen seen(speed::knotScene(state.range(0)), kSize);
    aliasFree(state, seen);
    state.SetComplexityN(state.range(0));
}
BENCHMARK(aliasFreeByPixels)
    ->RangeMultiplier(2)
    ->Range(160, 1280)
    ->Unit(benchmark::kMillisecond)
    ->Complexity(benchmark::oN);
// No tree: every triangle is drawn over the points' buckets.
BENCHMARK(aliasFreeByTriangles)
    ->RangeMultiplier(4)
    ->Range(1 << 12, 1 << 18)
    ->Unit(benchmark::kMillisecond)
    ->Complexity(benchmark::oN);

/// Slow on purpose: boxes around runs of triangles are all that it has, so it grows with their number.
void judge(benchmark::State& state) {
    const scene::Snapshot scene = testing::snapshot(speed::knotScene(state.range(0)));
    const trace::ExactVisibility exact(scene);
    for (auto _ : state)
        for (int i = 0; i < 64; ++i)
            benchmark::DoNotOptimize(exact.at(scene->camera, dvec2(2.5 * i + 0.5, 1.4 * i + 0.5), kSize, 0));
    state.SetComplexityN(state.range(0));
}
BENCHMARK(judge)->RangeMultiplier(4)->Range(1 << 10, 1 << 16)->Unit(benchmark::kMillisecond)->Complexity(benchmark::oN);

} // namespace
} // namespace shadowlab
