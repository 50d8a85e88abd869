// The stages that show what the rays of a picture found.
// SPDX-License-Identifier: MIT
#pragma once
#include "techniques/frame.h"
#include "techniques/ray_tracing/picture.h"

namespace shadowlab::ray_tracing {

/// How far from the eye its rays end.
void publishDistances(Frame& frame, const trace::SceneTracer& tracer, const Picture& picture);

/// What came of the shadow rays to a light, and which of it is the visibility that all techniques publish.
void publishShadowRays(Frame& frame, const Picture& picture, int light);
void publishVisibility(Frame& frame, const Picture& picture, int light);

/// What reflection or refraction rays add; nothing at all where no tree was traced.
void publishAdded(Frame& frame, std::string_view stage, const Picture& picture, const Grid<vec3>& addedFromBelow);

/// Of how many levels each pixel's tree is.
void publishLevels(Frame& frame, const Picture& picture);

} // namespace shadowlab::ray_tracing
