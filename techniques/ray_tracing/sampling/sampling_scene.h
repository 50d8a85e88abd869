// What sampling needs of a scene besides the acceleration structure: lights with an area in closed form, and motion. Cached
// between pictures.
// SPDX-License-Identifier: MIT
#pragma once
#include <optional>

#include "techniques/foundation/trace/moving_scene.h"
#include "techniques/ray_tracing/params.h"
#include "techniques/ray_tracing/sampling/analytic_lights.h"

namespace shadowlab::ray_tracing {

class SamplingScene {
public:
    /// The tracer must outlive this object.
    explicit SamplingScene(const trace::SceneTracer& tracer) : tracer_(tracer), atRest_(tracer) {}

    /// Prepares what the scene and the parameters need, once the tracer is ready; not converged when the deadline has passed.
    Progress prepare(const scene::Snapshot& snapshot, trace::Structure structure, const SamplingParams& params,
                     Deadline deadline);

    [[nodiscard]] const trace::MovingScene& atRest() const { return atRest_; }
    /// The scene while the shutter is open; if that is no time, the scene at rest.
    [[nodiscard]] const trace::MovingScene& moving() const { return moving_ ? *moving_ : atRest_; }
    /// nullptr: not asked for.
    [[nodiscard]] const AnalyticLights* analytic() const { return analytic_ ? &*analytic_ : nullptr; }

private:
    const trace::SceneTracer& tracer_;
    trace::MovingScene atRest_;
    std::optional<trace::MovingScene> moving_;
    std::optional<AnalyticLights> analytic_;
    // What they were built from.
    scene::Snapshot movingSnapshot_, analyticSnapshot_;
    trace::Structure movingStructure_ = trace::Structure::bvh;
};

} // namespace shadowlab::ray_tracing
