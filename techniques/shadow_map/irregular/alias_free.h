// The alias-free shadow map: Aila and Laine, "Alias-Free Shadow Maps", EGSR 2004.
//
// A shadow map samples depth at the centres of its texels, and then compares points that lie elsewhere: all its faults come from
// that. Here depth is sampled exactly where the eye looks. The visible points are projected into the
// light's picture plane and put into buckets there; every casting triangle is rasterised over the buckets, and tested
// against each sample in the buckets that it touches: within its three edges, and nearer to the light? No tree, no
// resolution, no bias. What it costs is a pass over all triangles for each picture, and for each light.
//
// The tests are made in float, with a bound for their error; where the bound leaves the answer open, the tracer tests this triangle
// and this sample. So every answer is that of a shadow ray.
// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "techniques/foundation/trace/scene_tracer.h"
#include "techniques/shadow_map/irregular/light_plane.h"

namespace shadowlab::shadow_map {

/// What was done, for pictures that show it: the light's planes, and the buckets that lie in them.
struct AliasFreeRecord {
    struct Bucket {
        int plane;               ///< of the planes below
        PlaneRect rect;          ///< of its samples, in places of the plane
        std::uint32_t samples;   ///< how many the eye needs there
        std::uint32_t lit;       ///< of these, how many are lit
        std::uint32_t triangles; ///< were tested against its samples
    };
    std::vector<LightPlane> planes;
    std::vector<Bucket> buckets;
    std::uint64_t samples = 0;      ///< that were asked: they face the light, and receive shadows
    std::uint64_t overlaps = 0;     ///< pairs of triangle and bucket that were tested
    std::uint64_t askedExactly = 0; ///< pairs of triangle and sample that float left open
};

/// The answers of tracer.visibilities(points, light, answers), for every point, the same for any number of threads
/// (0: as many as trace::threadCount() says). The tracer has been advanced to the scene. A light with an area is its centre.
void aliasFreeVisibilities(const trace::SceneTracer& tracer, std::span<const trace::SurfacePoint> points, int light,
                           std::span<trace::Visibility> answers, AliasFreeRecord* record = nullptr, int threads = 0);

} // namespace shadowlab::shadow_map
