// Whole frames of the techniques that rasterise, by triangles, lights and pixels; of the shadow map also by texels. The light moves
// from frame to frame, so that nothing is kept.
// SPDX-License-Identifier: MIT
#include <benchmark/benchmark.h>

#include "app/session/session.h"
#include "app/session/settings.h"
#include "tests/speed/hot_paths/meshes.h"

namespace shadowlab {
namespace {

void drawMoving(benchmark::State& state, const char* technique, scene::Scene scene, ivec2 size,
                const std::vector<std::string>& settings = {}) {
    session::Session session(testing::snapshot(scene));
    std::vector<session::Slot> slots;
    slots.push_back(session::Session::makeSlot(technique));
    session::applySettings(slots, settings);
    View view;
    view.camera = scene.camera;
    view.size = size;
    session.render(slots[0], view);
    for (auto _ : state) {
        for (scene::Light& light : scene.lights)
            light.positionWorld.x += 0.01;
        scene.revisions.lights = scene::newRevision();
        session.setScene(testing::snapshot(scene));
        session.render(slots[0], view);
    }
}

void frameByTriangles(benchmark::State& state, const char* technique) {
    drawMoving(state, technique, speed::knotScene(state.range(0)), {320, 180});
    state.SetComplexityN(state.range(0));
}
void frameByLights(benchmark::State& state, const char* technique) {
    drawMoving(state, technique, speed::knotScene(2000, static_cast<int>(state.range(0))), {320, 180});
    state.SetComplexityN(state.range(0));
}
void frameByPixels(benchmark::State& state, const char* technique) {
    const auto width = static_cast<int>(state.range(0));
    const ivec2 size(width, width * 9 / 16);
    drawMoving(state, technique, speed::knotScene(2000), size);
    state.SetComplexityN(std::int64_t{size.x} * size.y);
}
void mapByTexels(benchmark::State& state, const char* filter) {
    drawMoving(state, "shadow-map", speed::knotScene(2000), {320, 180},
               {"shadow-map.resolution=" + std::to_string(state.range(0)), std::string("shadow-map.filter=") + filter});
    state.SetComplexityN(state.range(0) * state.range(0));
}

const int registered = [] {
    for (const char* technique :
         {"unshadowed", "planar", "shadow-map", "shadow-volume-zpass", "shadow-volume-zfail", "shadow-volume"}) {
        const auto add = [&](const char* what, void (*run)(benchmark::State&, const char*)) {
            return benchmark::RegisterBenchmark((std::string(what) + "/" + technique).c_str(), run, technique)
                ->Unit(benchmark::kMillisecond)
                ->UseRealTime()
                ->Complexity(benchmark::oN);
        };
        add("frameByTriangles", frameByTriangles)->RangeMultiplier(4)->Range(1 << 10, 1 << 16);
        add("frameByLights", frameByLights)->RangeMultiplier(2)->Range(1, 8);
        add("frameByPixels", frameByPixels)->RangeMultiplier(2)->Range(160, 1280);
    }
    for (const char* filter : {"hard", "pcf", "vsm"})
        benchmark::RegisterBenchmark((std::string("mapByTexels/") + filter).c_str(), mapByTexels, filter)
            ->Unit(benchmark::kMillisecond)
            ->UseRealTime()
            ->RangeMultiplier(2)
            ->Range(256, 2048)
            ->Complexity(benchmark::oN);
    return 0;
}();

} // namespace
} // namespace shadowlab
