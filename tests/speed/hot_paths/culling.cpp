// What is left out of a frame, and what finding that costs, by objects. Each object's box is looked at once: linear.
// SPDX-License-Identifier: MIT
#include <benchmark/benchmark.h>

#include "techniques/foundation/gl/scene/surfaces.h"
#include "techniques/foundation/scene/query/casters.h"
#include "techniques/foundation/scene/query/view/depth_fit.h"
#include "techniques/foundation/scene/query/view/light_reach.h"
#include "techniques/foundation/scene/query/view/visible_receivers.h"
#include "techniques/planar/casters.h"
#include "techniques/planar/flattening.h"
#include "techniques/planar/receivers/receivers.h"
#include "techniques/shadow_map/fit/shadowed_part.h"
#include "tests/speed/hot_paths/meshes.h"

namespace shadowlab {
namespace {

constexpr std::int64_t kFewest = 1 << 4, kMost = 1 << 12;
constexpr ivec2 kSize{640, 360};

/// So many tori over a floor, and what a frame knows of them.
struct Field {
    scene::Scene scene = testing::floorScene();
    std::vector<scene::Bounds> bounds;
    gl::EyeMatrices eye;

    explicit Field(std::int64_t objects) {
        scene.lights.push_back(testing::pointLight({4, 9, 3}));
        const auto torus = std::make_shared<const scene::Mesh>(scene::makeTorus(0.2, 0.08, {8, 5}));
        // The more, the closer together: the same share of them is in view, and at its border.
        const auto columns = static_cast<std::int64_t>(std::ceil(std::sqrt(static_cast<double>(objects))));
        const double step = 9.4 / static_cast<double>(columns);
        for (std::int64_t i = 0; i < objects; ++i) {
            const auto column = static_cast<double>(i % columns), row = static_cast<double>(i / columns);
            testing::addObject(scene, *torus, testing::translation({step * column - 4.7, 0.3, step * row - 4.7}));
        }
        bounds = scene::objectBounds(scene);
        eye = gl::eyeMatrices(scene.camera, kSize);
        eye.part = scene::PicturePart{};
    }
    [[nodiscard]] dmat4 clipFromWorld() const { return eye.clipFromView * eye.viewFromWorld; }
};

template <typename Work>
void byObjects(benchmark::State& state, const Work& work) {
    const Field field(state.range(0));
    for (auto _ : state)
        benchmark::DoNotOptimize(work(field));
    state.SetComplexityN(state.range(0));
}

/// Can its shadow fall on anything? Of small meshes the vertices are looked at, whether they lie in one plane.
void usefulCasters(benchmark::State& state) {
    byObjects(state, [](const Field& f) { return scene::usefulCasters(f.scene, f.scene.lights[0], f.bounds).size(); });
}
BENCHMARK(usefulCasters)->RangeMultiplier(4)->Range(kFewest, kMost)->Complexity(benchmark::oN);

/// Does a spot light anything in view? It shines upward from above all, so that no object ends the search.
void lightReach(benchmark::State& state) {
    byObjects(state, [](const Field& f) {
        scene::Light spot = f.scene.lights[0];
        spot.type = scene::LightType::spot;
        spot.directionWorld = {0, 1, 0};
        spot.coneDegrees = 40;
        return scene::mayLight(f.scene, spot, f.bounds, f.scene.camera.positionWorld, f.clipFromWorld(), *f.eye.part);
    });
}
BENCHMARK(lightReach)->RangeMultiplier(4)->Range(kFewest, kMost)->Complexity(benchmark::oN);

void visibleReceivers(benchmark::State& state) {
    byObjects(state, [](const Field& f) {
        return scene::visibleReceivers(f.scene, f.bounds, f.clipFromWorld(), *f.eye.part, 64).size();
    });
}
BENCHMARK(visibleReceivers)->RangeMultiplier(4)->Range(kFewest, kMost)->Complexity(benchmark::oN);

/// Boxes are sorted from near to far, but of a few thousand that is not felt.
void nearPlane(benchmark::State& state) {
    byObjects(state,
              [](const Field& f) { return scene::withTightNear(f.scene.camera, f.scene, f.bounds, 16.0 / 9.0).near; });
}
BENCHMARK(nearPlane)->RangeMultiplier(4)->Range(kFewest, kMost)->Complexity(benchmark::oN);

/// Where in the picture a shadow map has to be asked, of each object.
void askedParts(benchmark::State& state) {
    shadow_map::LightMaps maps;
    maps.originWorld = {4, 9, 3};
    maps.lightViewFromLightRelative = {shadow_map::lookAlong(glm::normalize(dvec3(-4, -9, -3)))};
    maps.lightClipFromLightView = {shadow_map::perspectiveProjection(dvec2(-0.6), dvec2(0.6), 1, 20)};
    byObjects(state, [&](const Field& f) {
        double sum = 0;
        for (const scene::Bounds& box : f.bounds)
            if (const auto part = shadow_map::shadowedPart(maps, std::span(&box, 1), f.clipFromWorld()))
                sum += part->lower.x;
        return sum;
    });
}
BENCHMARK(askedParts)->RangeMultiplier(4)->Range(kFewest, kMost)->Complexity(benchmark::oN);

/// The matrices that flatten onto each plane in view, and the casters that fall on it: here one plane, the floor.
void planarProjection(benchmark::State& state) {
    Field field(state.range(0));
    const scene::Snapshot snapshot = testing::snapshot(field.scene);
    planar::Casters casters;
    casters.update(snapshot);
    planar::Receivers receivers;
    while (!receivers.findNext(snapshot)) {
    }
    const planar::PlanarParams params;
    const planar::Choice choice = planar::choose(receivers.inView(*snapshot, field.eye, field.bounds), params.receivers,
                                                 planar::apartInPicture(kSize));
    if (choice.receivers.empty()) state.SkipWithError("no plane is in view: there is nothing to project onto");
    for (auto _ : state)
        benchmark::DoNotOptimize(planar::litPlanes(*snapshot, choice.receivers, casters, field.eye,
                                                   dvec4(snapshot->lights[0].positionWorld, 1), snapshot->lights[0],
                                                   params, false));
    state.SetComplexityN(state.range(0));
}
BENCHMARK(planarProjection)->RangeMultiplier(4)->Range(kFewest, kMost)->Complexity(benchmark::oN);

} // namespace
} // namespace shadowlab
