// What is done with a finished picture, by pixels: metrics and PNG.
// SPDX-License-Identifier: MIT
#include <benchmark/benchmark.h>

#include "app/judge/metrics/flip.h"
#include "app/judge/metrics/image_metrics.h"
#include "techniques/foundation/image/png/png.h"

namespace shadowlab {
namespace {

/// A square of that side: a slope with some hard edges, as pictures are.
image::Image picture(std::int64_t side, int shift) {
    image::Image image;
    image.width = image.height = static_cast<int>(side);
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x) {
            const bool dark = ((x + shift) / 37 + y / 23) % 3 == 0;
            const auto grey = static_cast<std::uint8_t>((x + 2 * y) % 200 / (dark ? 3 : 1));
            image.rgba.insert(image.rgba.end(), {grey, grey, static_cast<std::uint8_t>(grey / 2), 255});
        }
    return image;
}

template <typename Work>
void byPixels(benchmark::State& state, const Work& work) {
    const image::Image a = picture(state.range(0), 0), b = picture(state.range(0), 2);
    for (auto _ : state)
        benchmark::DoNotOptimize(work(a, b));
    state.SetComplexityN(state.range(0) * state.range(0));
}

void flip(benchmark::State& state) {
    byPixels(state, [](const auto& a, const auto& b) { return judge::flip(a, b); });
}
void ssim(benchmark::State& state) {
    byPixels(state, [](const auto& a, const auto& b) { return judge::ssim(a, b); });
}
void encodePng(benchmark::State& state) {
    byPixels(state, [](const auto& a, const auto&) { return image::encodePng(a); });
}
BENCHMARK(flip)->RangeMultiplier(2)->Range(64, 512)->Unit(benchmark::kMillisecond)->Complexity(benchmark::oN);
BENCHMARK(ssim)->RangeMultiplier(2)->Range(64, 512)->Unit(benchmark::kMillisecond)->Complexity(benchmark::oN);
BENCHMARK(encodePng)->RangeMultiplier(2)->Range(64, 512)->Unit(benchmark::kMillisecond)->Complexity(benchmark::oN);

} // namespace
} // namespace shadowlab
