// How many points per second are told what they get of a light with an area, exactly and by samples.
//
//   ninja -C build/release area_light_bench && build/release/tests/area_light_bench assets/scenes/room-with-lamps.json
//
// The points are where eye rays end through the pixels of a picture, in squares of 16 x 16. For each light that has an area, the
// median rate, in thousands of points that face it per second of one core's time, of
//   share        AreaVisibility::shares: the visible share of its area
//   irradiance   AreaVisibility::irradiances, which adds what the pieces weigh
//   directions   16 directions of LightSampler, nothing asked
//   rays         the same 16, each with a ray
// All take turns, so that whatever else the machine does falls on all alike.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <cstdio>
#include <ctime>
#include <vector>

#include "techniques/foundation/scene/load/load.h"
#include "techniques/foundation/trace/area/area_visibility.h"
#include "techniques/foundation/trace/bvh/bvh_traverse.h"
#include "techniques/foundation/trace/parallel.h"
#include "techniques/ray_tracing/sampling/light_sampling.h"

namespace shadowlab {
namespace {

using namespace trace;

constexpr ivec2 kSize{320, 192};
constexpr int kTile = 16, kRounds = 5, kSamplesRoot = 4;
constexpr const char* kNames[] = {"share", "irradiance", "directions", "rays"};

struct Tile {
    std::vector<SurfacePoint> points; ///< that face the light
    std::vector<dvec3> normals;       ///< of their triangles
};

std::vector<Tile> tilesOf(const SceneTracer& tracer, int light) {
    const EyeRays rays = tracer.eyeRays(tracer.scene().camera, kSize);
    std::vector<Tile> tiles;
    for (int y = 0; y < kSize.y; y += kTile)
        for (int x = 0; x < kSize.x; x += kTile) {
            std::vector<SurfacePoint> points(std::size_t{kTile} * kTile);
            tracer.eyePoints(rays, {x, y}, ivec2(kTile), dvec2(0.5), points);
            Tile& tile = tiles.emplace_back();
            for (const SurfacePoint& point : points) {
                if (!point || !tracer.facesLight(point, light)) continue;
                const Triangle& own = tracer.bvh().triangles[point.primitive];
                const dvec3 up = glm::normalize(glm::cross(own.b - own.a, own.c - own.a));
                tile.points.push_back(point);
                tile.normals.push_back(point.eyeOnFront ? up : -up);
            }
        }
    return tiles;
}

/// What 16 directions find, one in each of as many equal parts of the light.
double estimate(const SceneTracer& tracer, int light, const Tile& tile, bool withRays) {
    double sum = 0;
    for (std::size_t i = 0; i < tile.points.size(); ++i) {
        const SurfacePoint& point = tile.points[i];
        const dvec3 from = tracer.positionCentred(point);
        const ray_tracing::LightSampler sampler(tracer.scene().light(light), tracer.positionWorld(point));
        for (int n = 0; n < kSamplesRoot * kSamplesRoot; ++n) {
            const auto sample =
                sampler.sample((dvec2(n % kSamplesRoot, n / kSamplesRoot) + 0.5) / double(kSamplesRoot));
            const Ray ray{from, sample.onLightCentredOffset, kContact, 1 - kContact};
            const auto casts = [&](std::uint32_t primitive) {
                return primitive != point.primitive &&
                       tracer.scene().objects[tracer.world().objects[primitive]].castsShadow;
            };
            if (!withRays || tracer.bvh().any(ray, casts) == kNoPrimitive)
                sum += sample.solidAngle * std::max(0.0, glm::dot(tile.normals[i], sample.towardWorld));
        }
    }
    return sum;
}

void measure(const SceneTracer& tracer, int light) {
    const AreaVisibility area(tracer, light);
    const std::vector<Tile> tiles = tilesOf(tracer, light);
    std::size_t points = 0;
    for (const Tile& tile : tiles)
        points += tile.points.size();
    std::atomic<double> kept = 0; // so that no answer is left out as unused
    std::array<std::vector<double>, 4> rates;
    for (int round = 0; round < kRounds; ++round)
        for (std::size_t way = 0; way < rates.size(); ++way) {
            const std::clock_t start = std::clock(); // of all threads together
            parallelFor(tiles.size(), [&](std::size_t i) {
                const Tile& tile = tiles[i];
                if (tile.points.empty()) return;
                if (way == 0) {
                    std::vector<AreaShare> shares(tile.points.size());
                    area.shares(tile.points, {}, shares);
                    kept += shares[0].visible;
                } else if (way == 1) {
                    std::vector<AreaIrradiance> irradiances(tile.points.size());
                    area.irradiances(tile.points, tile.normals, irradiances);
                    kept += irradiances[0].irradiance;
                } else {
                    kept += estimate(tracer, light, tile, way == 3);
                }
            });
            const double seconds = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
            rates[way].push_back(static_cast<double>(points) / seconds / 1000);
        }
    std::printf("%-10s %8zu points", tracer.scene().light(light).name.c_str(), points);
    for (std::size_t way = 0; way < rates.size(); ++way) {
        std::ranges::sort(rates[way]);
        std::printf("  %s %.0f k/s", kNames[way], rates[way][kRounds / 2]);
    }
    std::printf("%s\n", kept > 0 ? "" : "  nothing is seen of it");
}

int benchMain(int argc, char** argv) {
    if (argc != 2) {
        std::fprintf(stderr, "area_light_bench SCENE.json\n");
        return 2;
    }
    const scene::Snapshot snapshot = scene::loadScene(argv[1], {.assetsRoot = {}, .allowed = {}, .limits = {}});
    SceneTracer tracer;
    tracer.advance(snapshot, std::chrono::steady_clock::time_point::max());
    std::printf("%s, %d x %d\n", argv[1], kSize.x, kSize.y);
    for (std::size_t light = 0; light < snapshot->lights.size(); ++light)
        if (scene::hasArea(snapshot->lights[light])) measure(tracer, static_cast<int>(light));
    return 0;
}

} // namespace
} // namespace shadowlab

int main(int argc, char** argv) { return shadowlab::benchMain(argc, argv); }
