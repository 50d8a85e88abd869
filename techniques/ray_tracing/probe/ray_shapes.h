// Rays as lines in the scene: a few of a picture's rays, and where such lines end.
// SPDX-License-Identifier: MIT
#pragma once
#include <vector>

#include "techniques/foundation/trace/scene_tracer.h"
#include "techniques/technique.h"

namespace shadowlab::ray_tracing {

/// For one point in each cell of a grid over the view: the eye ray to it, and the shadow ray from it to the light, which ends at
/// the light or at the first blocker. A cell's point is its centre; where part of the cell is in shadow, a point in shadow. Rays
/// to a directional light end at the scene's bounding box. The background has no rays; surfaces that face away from the light, or
/// receive no shadow, have no shadow ray.
std::vector<SceneShape> rayShapes(const trace::SceneTracer& tracer, const View& view, int light);

/// The bounding box of the whole scene.
scene::Bounds boundsOf(const scene::Scene& scene);

/// Where the line of a ray that hits nothing ends: a little beyond the scene's bounding box.
dvec3 endBeyond(const scene::Bounds& bounds, const dvec3& fromWorld, const dvec3& directionWorld);

/// The end of a shadow ray: its blocker, or the light, or, for a directional light, a little beyond the scene.
dvec3 shadowRayEnd(const trace::SceneTracer& tracer, const trace::SurfacePoint& point, int light,
                   const scene::Bounds& bounds);

} // namespace shadowlab::ray_tracing
