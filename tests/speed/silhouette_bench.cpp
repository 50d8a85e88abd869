// How long the CPU's part of a shadow volume takes, beside merely reading the arrays it is made from.
//
//   ninja -C build/release silhouette_bench && build/release/tests/silhouette_bench [PLOT.svg]
//
// Prints a table: for 10^3 to 10^6 triangles the median time of
//   read    adding up all that the building reads: planes, triangles, the triangles of each edge
//   build   facing signs, silhouette, sides and caps, for a light far from where it was
//   creep   the same for a light that moves by a thousandth of the mesh's size at a time
//   plain   what the same took triangle by triangle and edge by edge, every list growing by itself
// and the ratio of build and creep to read. The ways take turns, so that whatever else the machine does falls on all alike.
// The mesh is a knot. Both of its sides count, as those of meshes do that are not certain to be simple (outward_parts.h).
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <functional>
#include <memory>
#include <numeric>
#include <random>

#include "techniques/foundation/scene/model/scene.h"
#include "techniques/foundation/scene/query/facing.h"
#include "techniques/foundation/scene/query/facing_planes.h"
#include "techniques/shadow_volume/count/volume.h"
#include "tests/speed/growth_plot.h"
#include "tests/speed/median.h"
#include "tests/support/trefoil.h"

namespace shadowlab {
namespace {

/// The same mesh with its triangles in no order: the worst for whoever looks up neighbours.
void shuffle(scene::Mesh& mesh) { std::ranges::shuffle(mesh.triangles, std::mt19937(1)); }

struct Ready {
    std::shared_ptr<const scene::Mesh> mesh;
    scene::MeshTopology topology;
    scene::FacingPlanes planes;
    shadow_volume::EdgeTable edges;
    explicit Ready(scene::Mesh made)
        : mesh(std::make_shared<const scene::Mesh>(std::move(made))), topology(scene::buildTopology(*mesh)),
          planes(mesh), edges(shadow_volume::edgeTable(topology)) {}
};

/// The sum of an array's words of 64 bits, in four parts that do not wait for each other.
template <typename T>
std::uint64_t sumOf(std::span<const T> array) {
    const auto* const words = reinterpret_cast<const std::uint64_t*>(array.data());
    const std::size_t count = array.size_bytes() / sizeof(std::uint64_t);
    std::uint64_t sum[4] = {};
    for (std::size_t i = 0; i + 4 <= count; i += 4)
        for (std::size_t k = 0; k < 4; ++k)
            sum[k] += words[i + k];
    return sum[0] + sum[1] + sum[2] + sum[3];
}

std::uint64_t read(const Ready& ready) {
    std::uint64_t sum = 0;
    for (int i = 0; i < 4; ++i)
        sum += sumOf(ready.planes.coordinates(i));
    sum += sumOf(std::span<const uvec3>(ready.mesh->triangles));
    return sum + sumOf(std::span<const shadow_volume::EdgeTable::Ordinary>(ready.edges.ordinary));
}

struct Kept {
    std::vector<std::int8_t> facing;
    std::vector<shadow_volume::SilhouetteEdge> silhouette;
    shadow_volume::Volume volume;
};

void build(const Ready& ready, const dvec4& lightMesh, Kept& kept) {
    kept.facing.resize(ready.planes.size());
    ready.planes.findSigns(lightMesh, kept.facing);
    shadow_volume::buildVolume(*ready.mesh, ready.edges, kept.facing, kept.silhouette, kept.volume);
}

/// As it was done before planes and edges were laid out for it.
Kept buildPlainly(const Ready& ready, const dvec4& lightMesh) {
    Kept kept;
    const scene::Mesh& mesh = *ready.mesh;
    const auto position = [&](std::uint32_t v) { return dvec3(mesh.positionsMesh[v]); };
    for (const uvec3& t : mesh.triangles)
        kept.facing.push_back(scene::facingSign(position(t.x), position(t.y), position(t.z), lightMesh));
    for (const scene::Edge& edge : ready.topology.edges) {
        int sum = 0;
        for (std::uint32_t u = edge.firstUse; u < edge.firstUse + edge.useCount; ++u)
            sum += ready.topology.uses[u].direction * kept.facing[ready.topology.uses[u].triangle];
        const auto times = static_cast<std::uint32_t>(std::abs(sum));
        if (sum > 0) kept.silhouette.push_back({edge.a, edge.b, times, edge.useCount});
        if (sum < 0) kept.silhouette.push_back({edge.b, edge.a, times, edge.useCount});
    }
    const auto n = static_cast<std::uint32_t>(mesh.positionsMesh.size());
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        const uvec3& corner = mesh.triangles[t];
        if (kept.facing[t] == 0) continue;
        const bool front = kept.facing[t] > 0;
        std::vector<std::uint32_t>& top = front ? kept.volume.topCap : kept.volume.topCapReversed;
        top.insert(top.end(), {corner.x, corner.y, corner.z});
        kept.volume.bottomCap.insert(kept.volume.bottomCap.end(), {corner.x + n, (front ? corner.z : corner.y) + n,
                                                                   (front ? corner.y : corner.z) + n});
    }
    for (const shadow_volume::SilhouetteEdge& edge : kept.silhouette)
        for (std::uint32_t i = 0; i < edge.multiplicity; ++i)
            kept.volume.sides.insert(kept.volume.sides.end(),
                                     {edge.b, edge.a, edge.a + n, edge.b, edge.a + n, edge.b + n});
    return kept;
}

double milliseconds(const std::function<void()>& run) {
    const auto start = std::chrono::steady_clock::now();
    run();
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

constexpr int kRuns = 31;

/// One line of the table. Small meshes are handled several times in a row, so that the clock can tell.
std::uint64_t measure(const char* name, const Ready& ready, std::vector<Times>& growth) {
    const std::size_t triangles = ready.mesh->triangles.size();
    const int times = static_cast<int>(std::max<std::size_t>(1, 200000 / triangles));
    Kept far, near;
    std::uint64_t sum = 0;
    std::size_t found = 0;
    std::vector<double> ms[4];
    for (int run = 0; run < kRuns; ++run) {
        const double turn = 2.4 * run; // radians: about a golden section of the circle, never twice alike
        ms[0].push_back(milliseconds([&] {
            for (int i = 0; i < times; ++i)
                sum += read(ready);
        }));
        ms[1].push_back(milliseconds([&] {
            for (int i = 0; i < times; ++i)
                build(ready, dvec4(8 * std::cos(turn + i), 8 * std::sin(turn + i), 5, 1), far);
        }));
        ms[2].push_back(milliseconds([&] {
            for (int i = 0; i < times; ++i)
                build(ready, dvec4(8, 0.006 * (run * times + i), 5, 1), near);
        }));
        ms[3].push_back(milliseconds([&] {
            for (int i = 0; i < times; ++i)
                found =
                    buildPlainly(ready, dvec4(8 * std::cos(turn + i), 8 * std::sin(turn + i), 5, 1)).silhouette.size();
        }));
    }
    double each[4];
    for (int i = 0; i < 4; ++i)
        each[i] = median(ms[i]) / times;
    std::printf("%-9s %9zu %10zu %10.4f %10.4f %10.4f %10.4f %11.2f %11.2f\n", name, triangles, found, each[0], each[1],
                each[2], each[3], each[1] / each[0], each[2] / each[0]);
    growth.push_back({static_cast<double>(triangles), each[0], each[1], each[2], each[3]});
    return sum;
}

} // namespace
} // namespace shadowlab

int main(int argc, char** argv) {
    using namespace shadowlab;
    std::vector<Times> growth;
    std::printf("median of %d runs, milliseconds\n", kRuns);
    std::printf("%-9s %9s %10s %10s %10s %10s %10s %11s %11s\n", "order", "triangles", "silhouette", "read", "build",
                "creep", "plain", "build/read", "creep/read");
    std::uint64_t sum = 0;
    for (const std::uint32_t around : {10u, 32u, 100u, 316u}) {
        const Ready inRows(testing::trefoil(0.3, 5 * around, around));
        sum += measure("in rows", inRows, growth);
    }
    scene::Mesh mesh = testing::trefoil(0.3, 5 * 316, 316);
    shuffle(mesh);
    sum += measure("shuffled", Ready(std::move(mesh)), growth);
    growth.pop_back(); // of that there is one size only
    if (argc > 1) std::ofstream(argv[1]) << growthPlot(growth);
    return sum == 1; // nobody may leave the reading out
}
