// SPDX-License-Identifier: MIT
#include "techniques/shadow_map/irregular/asked_samples.h"

#include <algorithm>
#include <atomic>
#include <limits>

namespace shadowlab::shadow_map {

namespace {

struct BoxCentred {
    dvec3 lower{std::numeric_limits<double>::infinity()}, upper{-std::numeric_limits<double>::infinity()};
    void include(const dvec3& position) {
        lower = glm::min(lower, position);
        upper = glm::max(upper, position);
    }
    void include(const BoxCentred& other) {
        lower = glm::min(lower, other.lower);
        upper = glm::max(upper, other.upper);
    }
};

/// Sets answers; puts the positions of those that ask into samples.places, as yet in centred space, and marks them. Returns
/// the middle of the box around them.
dvec3 gate(const ShadowQuery& query, Samples& samples) {
    const std::size_t count = query.points.size();
    samples.places.resize(count);
    samples.planeOf.assign(count, kNotAsked);
    std::vector<BoxCentred> boxes(count / kPointPiece + 1);
    inPieces(count, kPointPiece, query.threads, [&](std::size_t piece, std::size_t first, std::size_t end) {
        for (std::size_t i = first; i < end; ++i) {
            const trace::SurfacePoint& point = query.points[i];
            query.answers[i] = trace::Visibility::noSurface;
            if (!point) continue;
            const bool faces = query.tracer.facesLight(point, query.light);
            query.answers[i] = faces ? trace::Visibility::lit : trace::Visibility::turnedAway;
            if (!faces || !query.tracer.objectOf(point).receivesShadow) continue;
            samples.planeOf[i] = 0;
            samples.places[i] = query.tracer.positionCentred(point);
            boxes[piece].include(samples.places[i]);
        }
    });
    BoxCentred all;
    for (const BoxCentred& box : boxes)
        all.include(box);
    return all.lower.x <= all.upper.x ? 0.5 * (all.lower + all.upper) : dvec3(0.0);
}

/// Has every sample a place in one of the planes?
bool fitInto(const LightPlanes& planes, const ShadowQuery& query, const Samples& samples) {
    std::atomic<bool> fit = true;
    inPieces(samples.places.size(), kPointPiece, query.threads, [&](std::size_t, std::size_t first, std::size_t end) {
        for (std::size_t i = first; i < end && fit; ++i)
            if (samples.planeOf[i] != kNotAsked && planes.planeOf(samples.places[i]) < 0) fit = false;
    });
    return fit;
}

/// From centred space to the planes. A point that has no place there is answered by a ray.
void place(const ShadowQuery& query, const LightPlanes& planes, Samples& samples) {
    samples.planes.assign(planes.all().begin(), planes.all().end());
    const std::vector<PlaneRegion> none(samples.planes.size());
    std::vector<std::vector<PlaneRegion>> regions(samples.places.size() / kPointPiece + 1, none);
    inPieces(samples.places.size(), kPointPiece, query.threads,
             [&](std::size_t piece, std::size_t first, std::size_t end) {
                 for (std::size_t i = first; i < end; ++i) {
                     if (samples.planeOf[i] == kNotAsked) continue;
                     const int plane = planes.planeOf(samples.places[i]);
                     samples.planeOf[i] = plane < 0 ? kNotAsked : static_cast<std::uint8_t>(plane);
                     if (plane < 0) {
                         query.answers[i] = query.tracer.visibility(query.points[i], query.light);
                         continue;
                     }
                     samples.places[i] = samples.planes[samples.planeOf[i]].place(samples.places[i]);
                     PlaneRegion& region = regions[piece][samples.planeOf[i]];
                     region.box.include(samples.places[i]);
                     ++region.count;
                 }
             });
    samples.regions = none;
    for (const std::vector<PlaneRegion>& ofPiece : regions)
        for (std::size_t p = 0; p < none.size(); ++p) {
            samples.regions[p].box.include(ofPiece[p].box);
            samples.regions[p].count += ofPiece[p].count;
        }
}

} // namespace

Samples findSamples(const ShadowQuery& query) {
    Samples samples;
    const dvec3 middleCentred = gate(query, samples);
    const dvec3& originWorld = query.tracer.world().originWorld;
    const LightPlanes one = LightPlanes::one(query.source(), originWorld, middleCentred);
    if (query.isParallel() || fitInto(one, query, samples))
        place(query, one, samples);
    else
        place(query, LightPlanes::cube(query.source(), originWorld), samples);
    return samples;
}

} // namespace shadowlab::shadow_map
