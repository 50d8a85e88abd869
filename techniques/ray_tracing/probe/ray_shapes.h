// A few of the rays of a picture, as they lie in the scene.
// SPDX-License-Identifier: MIT
#pragma once
#include <vector>

#include "techniques/foundation/trace/scene_tracer.h"
#include "techniques/technique.h"

namespace shadowlab::ray_tracing {

/// For one point in each cell of a grid over the view: the ray from the eye to what the picture shows there, and from there
/// the ray to the light, which arrives or ends at the first thing in its way. A cell's point is its middle; where a part of
/// the cell is in shadow, a point in shadow. Toward the sun a ray ends where the scene does. The background has no rays;
/// surfaces that are turned away from the light, or receive no shadow, send none to it.
std::vector<SceneShape> rayShapes(const trace::SceneTracer& tracer, const View& view, int light);

/// The box around the whole scene.
scene::Bounds boundsOf(const scene::Scene& scene);

/// Where a ray that starts within the scene's box and goes on for ever is no longer drawn.
dvec3 endBeyond(const scene::Bounds& bounds, const dvec3& fromWorld, const dvec3& directionWorld);

/// Of a shadow ray: at what blocks it, else at the light, toward the sun a little beyond the scene.
dvec3 shadowRayEnd(const trace::SceneTracer& tracer, const trace::SurfacePoint& point, int light,
                   const scene::Bounds& bounds);

} // namespace shadowlab::ray_tracing
