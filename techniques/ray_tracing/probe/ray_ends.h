// Where rays that are drawn as lines end.
// SPDX-License-Identifier: MIT
#pragma once
#include "techniques/foundation/trace/scene_tracer.h"

namespace shadowlab::ray_tracing {

/// The box around the whole scene.
scene::Bounds boundsOf(const scene::Scene& scene);

/// Where a ray that starts within the scene's box and goes on for ever is no longer drawn.
dvec3 endBeyond(const scene::Bounds& bounds, const dvec3& fromWorld, const dvec3& directionWorld);

/// Of a shadow ray: at what blocks it, else at the light, toward the sun a little beyond the scene.
dvec3 shadowRayEnd(const trace::SceneTracer& tracer, const trace::SurfacePoint& point, int light,
                   const scene::Bounds& bounds);

} // namespace shadowlab::ray_tracing
