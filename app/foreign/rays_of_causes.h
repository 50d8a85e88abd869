// Rays that causes of errors ask with: to a light that may stand elsewhere, past casters that may be left out.
// SPDX-License-Identifier: MIT
#pragma once
#include <span>
#include <vector>

#include "app/foreign/evidence.h"

namespace shadowlab::foreign {

/// From a point toward a light, t from 0 at the point to 1 at the light; of a directional light t counts metres.
trace::Ray rayToLight(const trace::SceneTracer& tracer, const dvec3& fromCentred, const scene::Light& light);
trace::Ray rayToLight(const trace::SceneTracer& tracer, const trace::SurfacePoint& from, const scene::Light& light);
/// Metres that one unit of t is on that ray.
double metresPerT(const trace::Ray& ray, const scene::Light& light);

/// For each triangle 1 if it casts shadows of that light.
std::vector<std::uint8_t> castingTriangles(const Evidence& evidence);
/// The first triangle on the ray that `mayHit` lets through.
trace::RayHit closestOf(const trace::SceneTracer& tracer, const trace::Ray& ray, const trace::MayHit& mayHit);
/// Does any of the flagged triangles stand on the ray? The point's own does not.
bool isBlockedBy(const trace::SceneTracer& tracer, const trace::Ray& ray, std::uint32_t leftOut, std::span<const std::uint8_t> flags);

/// What would be seen with another light in place of the judged one: lit is what faces it, lies in its cone and is not in the shadow of
/// the triangles that `casts` flags.
Predictions withLight(const Evidence& evidence, const scene::Light& light, std::span<const std::uint8_t> casts);

/// +1: the light is on the counter-clockwise side, as the triangle lies in the world; -1: behind it; 0: in its plane.
std::vector<std::int8_t> sidesOfLight(const trace::SceneTracer& tracer, const scene::Light& light);

/// A triangle that a ray crosses.
struct Crossing {
    std::uint32_t primitive = 0;
    double t = 0;
    bool fromFront = false; ///< the ray comes from its counter-clockwise side
};
/// All flagged triangles on the ray, in order; no more than some hundred.
std::vector<Crossing> crossings(const trace::SceneTracer& tracer, const trace::Ray& ray, std::uint32_t leftOut,
                                std::span<const std::uint8_t> flags);

/// Is the object's surface closed, so that it has an inside?
std::vector<std::uint8_t> closedObjects(const scene::Scene& scene);

} // namespace shadowlab::foreign
