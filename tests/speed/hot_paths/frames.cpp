// Whole frames of the techniques, by triangles, lights and pixels; of the shadow map also by texels, of shadow volumes by the pixels
// that they cover, of radiosity by patches. The light moves from frame to frame, so that nothing is kept.
// SPDX-License-Identifier: MIT
#include <benchmark/benchmark.h>

#include "app/lab/settings.h"
#include "app/picture/session.h"
#include "tests/speed/hot_paths/meshes.h"

namespace shadowlab {
namespace {

void drawMoving(benchmark::State& state, const char* technique, scene::Scene scene, ivec2 size,
                const std::vector<std::string>& settings = {}) {
    picture::Session session(testing::snapshot(scene));
    std::vector<picture::Slot> slots;
    slots.push_back(picture::Session::makeSlot(technique));
    lab::applySettings(slots, settings);
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

/// What counting alone costs: 16 strips stand beside the picture, and a low sun draws the volume of each over all of it, between the eye
/// and the floor. Little is drawn but pixels, each some thirty times.
void stencilFill(benchmark::State& state, const char* technique) {
    scene::Scene scene = testing::floorScene();
    scene.objects.clear();
    testing::addObject(scene, scene::makeQuad({60, 60}));
    scene.camera.positionWorld = {0, 10, 6};
    for (int i = 0; i < 16; ++i) {
        const dvec4 middle(-29, 0.8 + 0.1 * i, 0, 1);
        testing::addObject(scene, scene::makeQuad({0.5, 60}),
                           dmat4(dvec4(0, 1, 0, 0), dvec4(-1, 0, 0, 0), dvec4(0, 0, 1, 0), middle));
    }
    scene.lights = {testing::directionalLight({1, -0.005, 0})}; // 0.3 m down on its way
    const auto width = static_cast<int>(state.range(0));
    const ivec2 size(width, width * 9 / 16);
    drawMoving(state, technique, scene, size);
    state.SetComplexityN(std::int64_t{size.x} * size.y);
}

/// From nothing to the first picture: form factors between all pairs of patches, the solution, the light map.
void radiosityByPatches(benchmark::State& state) {
    const scene::Scene scene = testing::simpleScene();
    View view;
    view.camera = scene.camera;
    view.size = {320, 180};
    for (auto _ : state) {
        picture::Session session(testing::snapshot(scene));
        std::vector<picture::Slot> slots;
        slots.push_back(picture::Session::makeSlot("radiosity"));
        lab::applySettings(slots, {"radiosity.direct=light-map", "radiosity.patches=" + std::to_string(state.range(0))});
        session.render(slots[0], view);
    }
    state.SetComplexityN(state.range(0));
}
BENCHMARK(radiosityByPatches)
    ->RangeMultiplier(2)
    ->Range(75, 600)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime() // on all cores
    ->Complexity(benchmark::oNSquared);

/// Of a room that is solved: the eye moves. A light map stays as it is; pixels ask anew.
void radiosityByPixels(benchmark::State& state, const std::vector<std::string>& settings) {
    const scene::Scene scene = testing::simpleScene();
    picture::Session session(testing::snapshot(scene));
    std::vector<picture::Slot> slots;
    slots.push_back(picture::Session::makeSlot("radiosity"));
    lab::applySettings(slots, {"radiosity.patches=75"});
    lab::applySettings(slots, settings);
    const auto width = static_cast<int>(state.range(0));
    View view;
    view.camera = scene.camera;
    view.size = {width, width * 9 / 16};
    session.render(slots[0], view);
    for (auto _ : state) {
        view.camera.positionWorld.x += 0.001;
        session.render(slots[0], view);
    }
    state.SetComplexityN(std::int64_t{view.size.x} * view.size.y);
}
BENCHMARK_CAPTURE(radiosityByPixels, light-map, std::vector<std::string>{"radiosity.direct=light-map"})
    ->RangeMultiplier(2)
    ->Range(160, 1280)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime()
    ->Complexity(benchmark::oN);
/// Direct light of each pixel, between patches.
BENCHMARK_CAPTURE(radiosityByPixels, direct, std::vector<std::string>{"radiosity.gather=none"})
    ->RangeMultiplier(2)
    ->Range(160, 1280)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime()
    ->Complexity(benchmark::oN);
/// The same, and some pixels gather. In corners all of them do, and these are fewer where pixels are finer: less than in proportion.
BENCHMARK_CAPTURE(radiosityByPixels, gather, std::vector<std::string>{})
    ->RangeMultiplier(2)
    ->Range(160, 1280)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime()
    ->Complexity(benchmark::oN);

const int registered = [] {
    for (const char* technique : {"unshadowed", "planar", "shadow-map", "shadow-volume-zpass", "shadow-volume-zfail",
                                  "shadow-volume", "ray-traced"}) {
        const auto add = [&](const char* what, void (*run)(benchmark::State&, const char*)) {
            return benchmark::RegisterBenchmark((std::string(what) + "/" + technique).c_str(), run, technique)
                ->Unit(benchmark::kMillisecond)
                ->UseRealTime()
                ->Complexity(benchmark::oN);
        };
        // Rays go down a tree, which stays as it is while the light moves alone; all others draw every triangle.
        const bool isTraced = std::string_view(technique) == "ray-traced";
        add("frameByTriangles", frameByTriangles)
            ->RangeMultiplier(4)
            ->Range(1 << 10, 1 << 16)
            ->Complexity(isTraced ? benchmark::oLogN : benchmark::oN);
        add("frameByLights", frameByLights)->RangeMultiplier(2)->Range(1, 8);
        add("frameByPixels", frameByPixels)->RangeMultiplier(2)->Range(160, 1280);
    }
    for (const char* technique : {"shadow-volume-zpass", "shadow-volume-zfail"})
        benchmark::RegisterBenchmark((std::string("stencilFill/") + technique).c_str(), stencilFill, technique)
            ->Unit(benchmark::kMillisecond)
            ->UseRealTime()
            ->RangeMultiplier(2)
            ->Range(160, 1280)
            ->Complexity(benchmark::oN);
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
