// What pictures are judged by, by pixels: the truth, with ties and without, the shadow's boundary in it, and how far from it each
// pixel is. All are linear: the boundary is looked for among all pixels, and its distance spreads from it.
// SPDX-License-Identifier: MIT
#include <benchmark/benchmark.h>

#include <chrono>

#include "app/judge/metrics/boundary.h"
#include "app/judge/truth.h"
#include "tests/speed/hot_paths/meshes.h"

namespace shadowlab {
namespace {

ivec2 sizeOf(const benchmark::State& state) {
    const auto width = static_cast<int>(state.range(0));
    return {width, width * 9 / 16};
}

template <typename Work>
void byPixels(benchmark::State& state, const Work& work) {
    const scene::Scene scene = speed::knotScene(1 << 12);
    trace::SceneTracer tracer;
    tracer.advance(testing::snapshot(scene), std::chrono::steady_clock::time_point::max());
    const ivec2 size = sizeOf(state);
    for (auto _ : state)
        benchmark::DoNotOptimize(work(tracer, scene.camera, size));
    state.SetComplexityN(std::int64_t{size.x} * size.y);
}

void truthAtCentres(benchmark::State& state) {
    byPixels(state, [](const auto& tracer, const auto& camera, ivec2 size) {
        return judge::truthAtCentres(tracer, camera, size, 0).visibility.size();
    });
}
void exactTruth(benchmark::State& state) {
    byPixels(state, [](const auto& tracer, const auto& camera, ivec2 size) {
        return judge::exactTruth(tracer, camera, size, 0, {}).ties.size();
    });
}
BENCHMARK(truthAtCentres)
    ->RangeMultiplier(2)
    ->Range(80, 640)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime() // on all cores
    ->Complexity(benchmark::oN);
BENCHMARK(exactTruth)
    ->RangeMultiplier(2)
    ->Range(80, 320)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime()
    ->Complexity(benchmark::oN);

/// Light and shadow in stripes as wide as those in pictures, all on one receiver.
judge::Grid<judge::Shade> stripes(ivec2 size) {
    judge::Grid<judge::Shade> shades(size.x, size.y);
    for (int y = 0; y < size.y; ++y)
        for (int x = 0; x < size.x; ++x)
            shades.at(x, y) = (x + y / 3) / 40 % 2 == 0 ? judge::Shade::lit : judge::Shade::shadowed;
    return shades;
}

void boundary(benchmark::State& state) {
    const ivec2 size = sizeOf(state);
    const judge::Grid<judge::Shade> shades = stripes(size);
    const judge::Grid<std::uint32_t> receivers(size.x, size.y, 0);
    for (auto _ : state)
        benchmark::DoNotOptimize(judge::boundaryEdges(shades, receivers));
    state.SetComplexityN(std::int64_t{size.x} * size.y);
}
void boundaryDistance(benchmark::State& state) {
    const ivec2 size = sizeOf(state);
    const auto edges = judge::boundaryEdges(stripes(size), judge::Grid<std::uint32_t>(size.x, size.y, 0));
    for (auto _ : state)
        benchmark::DoNotOptimize(judge::distanceToBoundary(edges, size));
    state.SetComplexityN(std::int64_t{size.x} * size.y);
}
BENCHMARK(boundary)->RangeMultiplier(2)->Range(160, 1280)->Unit(benchmark::kMillisecond)->Complexity(benchmark::oN);
BENCHMARK(boundaryDistance)
    ->RangeMultiplier(2)
    ->Range(160, 1280)
    ->Unit(benchmark::kMillisecond)
    ->Complexity(benchmark::oN);

} // namespace
} // namespace shadowlab
