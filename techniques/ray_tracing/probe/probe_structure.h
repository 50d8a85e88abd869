// What the eye ray of a pixel passes of the structure that rays are traced with.
// SPDX-License-Identifier: MIT
#pragma once
#include "techniques/foundation/trace/scene_tracer.h"
#include "techniques/probe.h"

namespace shadowlab::ray_tracing {

/// Fills Probe::structure, if the structure has parts to show. `toHit`: the eye ray, up to the first surface.
void describeStructure(const trace::SceneTracer& tracer, const trace::Engine& engine, const trace::Ray& toHit,
                       Probe& probe);

} // namespace shadowlab::ray_tracing
