// How long the alias-free shadow map takes, beside shadow rays to the same points.
//
//   ninja -C build/release alias_free_bench && build/release/tests/alias_free_bench
//
// A million pixels, nearly all of which ask the light; on a floor that fills the picture a knot of 10^3 to 10^6 triangles, or
// as many loose leaves as a tree has; and a light of each kind of picture plane: the sun, a point outside (one plane) and one
// amid all (six). For each the median of the times of
//   rays    SceneTracer::visibilities, the picture in blocks, on all cores
//   map     aliasFreeVisibilities, from points to answers
// and of the ratio. Both take turns, so that whatever else the machine does falls on both alike. The answers are compared; a
// point that differs ends the program with 1.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <random>
#include <vector>

#include "techniques/foundation/scene/model/shapes.h"
#include "techniques/foundation/trace/parallel.h"
#include "techniques/shadow_map/irregular/alias_free.h"
#include "tests/support/scenes.h"
#include "tests/support/trefoil.h"
#include "tests/speed/median.h"

namespace shadowlab {
namespace {

using namespace testing;
using trace::SceneTracer;
using trace::SurfacePoint;
using trace::Visibility;

constexpr ivec2 kSize{1280, 800};
constexpr int kRuns = 15;

double milliseconds(const auto& run) {
    const auto start = std::chrono::steady_clock::now();
    run();
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

scene::Mesh knot(std::uint32_t around) {
    scene::Mesh mesh = trefoil(0.3, 5 * around, around);
    mesh.normalsMesh.assign(mesh.positionsMesh.size(), vec3(0, 1, 0));
    mesh.parts = {{"", 0, static_cast<std::uint32_t>(mesh.triangles.size())}};
    return mesh;
}

/// Small triangles that lie any way, in a ball.
scene::Mesh leaves(int count) {
    std::mt19937 random(1);
    std::normal_distribution<double> normal;
    const auto anywhere = [&] { return dvec3(normal(random), normal(random), normal(random)); };
    std::vector<dvec3> corners;
    for (int i = 0; i < count; ++i) {
        const dvec3 middle = anywhere();
        for (int corner = 0; corner < 3; ++corner)
            corners.push_back(middle + 0.02 * anywhere());
    }
    return triangleSoup(corners);
}

scene::Scene sceneOf(scene::Mesh mesh) {
    scene::Scene scene = floorScene();
    scene.objects.clear();
    addObject(scene, scene::makeQuad({60, 60}));
    addObject(scene, std::move(mesh), translation({0, 2, 0}));
    scene.lights = {directionalLight({-0.3, -1, -0.5}), pointLight({2, 12, 5}), pointLight({0.1, 2.1, 0.2})};
    scene.camera.positionWorld = {0, 8, 8};
    return scene;
}

/// The points of a picture, block by block, as techniques ask for them.
std::vector<SurfacePoint> pointsOf(const SceneTracer& tracer) {
    const trace::EyeRays rays = tracer.eyeRays(tracer.scene().camera, kSize);
    constexpr int side = SceneTracer::kBlock;
    const ivec2 blocks = kSize / side;
    std::vector<SurfacePoint> points(static_cast<std::size_t>(kSize.x) * static_cast<std::size_t>(kSize.y));
    trace::parallelFor(static_cast<std::size_t>(blocks.x) * static_cast<std::size_t>(blocks.y), [&](std::size_t i) {
        const ivec2 block(static_cast<int>(i) % blocks.x, static_cast<int>(i) / blocks.x);
        tracer.eyePoints(rays, side * block, ivec2(side), dvec2(0.5),
                         std::span(points).subspan(i * side * side, side * side));
    });
    return points;
}

void traceAll(const SceneTracer& tracer, std::span<const SurfacePoint> points, int light,
              std::span<Visibility> answers) {
    constexpr std::size_t kPiece = 4096;
    trace::parallelFor(points.size() / kPiece, [&](std::size_t i) {
        tracer.visibilities(points.subspan(i * kPiece, kPiece), light, answers.subspan(i * kPiece, kPiece));
    });
}

bool measure(const char* casters, scene::Mesh mesh) {
    SceneTracer tracer;
    tracer.advance(snapshot(sceneOf(std::move(mesh))), std::chrono::steady_clock::time_point::max());
    const std::vector<SurfacePoint> points = pointsOf(tracer);
    std::vector<Visibility> rays(points.size()), map(points.size());
    bool same = true;
    for (int light = 0; light < static_cast<int>(tracer.scene().lights.size()); ++light) {
        shadow_map::AliasFreeRecord record;
        shadow_map::aliasFreeVisibilities(tracer, points, light, map, &record);
        traceAll(tracer, points, light, rays);
        const auto shadowed = std::ranges::count(rays, Visibility::shadowed);
        std::vector<double> raysMs, mapMs, ratios;
        for (int run = 0; run < kRuns; ++run) {
            raysMs.push_back(milliseconds([&] { traceAll(tracer, points, light, rays); }));
            mapMs.push_back(milliseconds([&] { shadow_map::aliasFreeVisibilities(tracer, points, light, map); }));
            ratios.push_back(mapMs.back() / raysMs.back());
        }
        same = same && rays == map;
        static constexpr const char* names[] = {"sun", "point, one plane", "point, amid all"};
        std::printf("%-7s %9zu %-17s %9zu %9td %10llu %8llu %9.1f %9.1f %9.2f%s\n", casters,
                    tracer.world().triangles.size(), names[light], static_cast<std::size_t>(record.samples), shadowed,
                    static_cast<unsigned long long>(record.overlaps),
                    static_cast<unsigned long long>(record.askedExactly), median(raysMs), median(mapMs), median(ratios),
                    rays == map ? "" : "   THEY DIFFER");
        std::fflush(stdout);
    }
    return same;
}

} // namespace
} // namespace shadowlab

int main() {
    std::printf("%d x %d pixels, median of %d runs, %d threads\n%-7s %9s %-17s %9s %9s %10s %8s %9s %9s %9s\n",
                shadowlab::kSize.x, shadowlab::kSize.y, shadowlab::kRuns, shadowlab::trace::threadCount(), "casters",
                "triangles", "light", "samples", "shadowed", "overlaps", "exact", "rays ms", "map ms", "map/rays");
    bool same = true;
    for (const std::uint32_t around : {10u, 32u, 100u, 316u})
        same = shadowlab::measure("knot", shadowlab::knot(around)) && same;
    for (const int count : {10'000, 100'000})
        same = shadowlab::measure("leaves", shadowlab::leaves(count)) && same;
    return same ? 0 : 1;
}
