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

} // namespace shadowlab::ray_tracing
