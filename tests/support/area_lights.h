// Lights with an area for tests, points to see them from, and an answer that is found with rays alone.
// SPDX-License-Identifier: MIT
#pragma once
#include "techniques/foundation/trace/scene_tracer.h"

namespace shadowlab::testing {

/// Shines to the side of cross(edgeU, edgeV).
scene::Light rectLight(const dvec3& centreWorld, const dvec3& edgeU, const dvec3& edgeV);
scene::Light sphereLight(const dvec3& centreWorld, double radius);

trace::SceneTracer tracerOf(const scene::Snapshot& snapshot);

/// The point of an object's surface at a place in the world, which must lie on one of its triangles; seen from the front.
trace::SurfacePoint surfacePointAt(const trace::SceneTracer& tracer, std::uint32_t object, const dvec3& positionWorld);

/// The share of the light that the point sees, by side x side rays to jittered places; of a sphere, to where rays meet its
/// surface. Tries every triangle, and shares no code with what it judges.
double sampledShare(const trace::SceneTracer& tracer, const trace::SurfacePoint& point, int light, int side);

} // namespace shadowlab::testing
