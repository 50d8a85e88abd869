// The first steps of the alias-free shadow map: which points need a test at all, and where the light sees them.
// SPDX-License-Identifier: MIT
#pragma once
#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "techniques/foundation/trace/parallel.h"
#include "techniques/foundation/trace/scene_tracer.h"
#include "techniques/shadow_map/irregular/light_plane.h"

namespace shadowlab::shadow_map {

/// The question that all steps work on: which of these points does the light reach?
struct ShadowQuery {
    const trace::SceneTracer& tracer;
    std::span<const trace::SurfacePoint> points;
    int light;
    std::span<trace::Visibility> answers; ///< one per point
    int threads;                          ///< as for trace::parallelFor
    [[nodiscard]] const scene::Light& source() const { return tracer.scene().light(light); }
    /// Of the scene: the largest difference of two coordinates.
    [[nodiscard]] double extent() const { return 2 * tracer.largestCentred(); }
    [[nodiscard]] bool isParallel() const { return source().type == scene::LightType::directional; }
};

/// Where the samples of one plane are.
struct PlaneRegion {
    PlaceBox box;
    std::size_t count = 0;
};

constexpr std::uint8_t kNotAsked = 0xff;

/// The points whose visibility is not known yet, as the light sees them.
struct Samples {
    std::vector<LightPlane> planes;
    std::vector<PlaneRegion> regions;  ///< of each plane
    std::vector<std::uint8_t> planeOf; ///< of each point: which plane it is in, or kNotAsked
    std::vector<dvec3> places;         ///< of each point: LightPlane::place()
};

/// Answers what needs no look at other triangles: background, what is turned away, what receives no shadow. All others are
/// answered `lit`, until something is found before them, and are in the samples.
Samples findSamples(const ShadowQuery& query);

/// Calls work(piece, first, end) for pieces of 0 ... count, on several threads.
template <typename Work>
void inPieces(std::size_t count, std::size_t size, int threads, const Work& work) {
    trace::parallelFor((count + size - 1) / size,
                       [&](std::size_t piece) { work(piece, piece * size, std::min(count, (piece + 1) * size)); },
                       threads);
}

// Points that one thread handles in a row: so many that starting on them costs nothing, so few that all cores get some.
constexpr std::size_t kPointPiece = 16384;

} // namespace shadowlab::shadow_map
