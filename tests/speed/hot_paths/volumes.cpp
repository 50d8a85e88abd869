// What a shadow volume is made from, by triangles.
// SPDX-License-Identifier: MIT
#include <benchmark/benchmark.h>

#include <memory>

#include "techniques/foundation/scene/query/facing.h"
#include "techniques/foundation/scene/query/facing_planes.h"
#include "techniques/foundation/scene/query/topology/mesh_topology.h"
#include "techniques/shadow_volume/count/edge_table.h"
#include "techniques/shadow_volume/count/volume.h"
#include "tests/speed/hot_paths/meshes.h"

namespace shadowlab {
namespace {

constexpr std::int64_t kFewest = 1 << 10, kMost = 1 << 18;

void topology(benchmark::State& state) {
    const scene::Mesh mesh = speed::knot(state.range(0));
    for (auto _ : state)
        benchmark::DoNotOptimize(scene::buildTopology(mesh));
    state.SetComplexityN(static_cast<std::int64_t>(mesh.triangles.size()));
}
BENCHMARK(topology)->RangeMultiplier(4)->Range(kFewest, kMost)->Complexity(benchmark::oNLogN);

void facingSigns(benchmark::State& state) {
    const auto mesh = std::make_shared<const scene::Mesh>(speed::knot(state.range(0)));
    const scene::FacingPlanes planes(mesh);
    std::vector<std::int8_t> signs(mesh->triangles.size());
    for (auto _ : state) {
        planes.findSigns(dvec4(3, 9, 2, 1), signs);
        benchmark::DoNotOptimize(signs.data());
        benchmark::ClobberMemory();
    }
    state.SetComplexityN(static_cast<std::int64_t>(signs.size()));
}
BENCHMARK(facingSigns)->RangeMultiplier(4)->Range(kFewest, kMost)->Complexity(benchmark::oN);

/// The silhouette alone, from signs that are known: every edge is looked at.
void silhouette(benchmark::State& state) {
    const auto mesh = std::make_shared<const scene::Mesh>(speed::knot(state.range(0)));
    const shadow_volume::EdgeTable edges = shadow_volume::edgeTable(scene::buildTopology(*mesh));
    std::vector<std::int8_t> signs(mesh->triangles.size());
    scene::FacingPlanes(mesh).findSigns(dvec4(3, 9, 2, 1), signs);
    for (auto _ : state) {
        std::uint32_t found = 0;
        shadow_volume::forEachSilhouetteEdge(edges, signs,
                                             [&](std::uint32_t, std::uint32_t, int, std::uint32_t) { ++found; });
        benchmark::DoNotOptimize(found);
    }
    state.SetComplexityN(static_cast<std::int64_t>(signs.size()));
}
BENCHMARK(silhouette)->RangeMultiplier(4)->Range(kFewest, kMost)->Complexity(benchmark::oN);

/// Silhouette, sides and caps, from signs that are known.
void volumeConstruction(benchmark::State& state) {
    const auto mesh = std::make_shared<const scene::Mesh>(speed::knot(state.range(0)));
    const shadow_volume::EdgeTable edges = shadow_volume::edgeTable(scene::buildTopology(*mesh));
    const scene::FacingPlanes planes(mesh);
    std::vector<std::int8_t> signs(mesh->triangles.size());
    planes.findSigns(dvec4(3, 9, 2, 1), signs);
    std::vector<shadow_volume::SilhouetteEdge> silhouette;
    shadow_volume::Volume volume;
    for (auto _ : state) {
        shadow_volume::buildVolume(*mesh, edges, signs, silhouette, volume);
        benchmark::DoNotOptimize(silhouette.data());
        benchmark::ClobberMemory();
    }
    state.SetComplexityN(static_cast<std::int64_t>(signs.size()));
}
BENCHMARK(volumeConstruction)->RangeMultiplier(4)->Range(kFewest, kMost)->Complexity(benchmark::oN);

} // namespace
} // namespace shadowlab
