// What a scene needs beyond its rays' structure, for lights with an area in closed form and for motion. Kept from picture to picture.
// SPDX-License-Identifier: MIT
#pragma once
#include <optional>

#include "techniques/foundation/trace/moving_scene.h"
#include "techniques/ray_tracing/params.h"
#include "techniques/ray_tracing/sampling/analytic_lights.h"

namespace shadowlab::ray_tracing {

class SamplingScene {
public:
    /// The tracer must live as long.
    explicit SamplingScene(const trace::SceneTracer& tracer) : tracer_(tracer), atRest_(tracer) {}

    /// Does what the scene and the parameters demand, once the tracer is ready; unconverged when the deadline passes.
    Progress prepare(const scene::Snapshot& snapshot, trace::Structure structure, const SamplingParams& params,
                     Deadline deadline);

    [[nodiscard]] const trace::MovingScene& atRest() const { return atRest_; }
    /// While the shutter is open; the scene at rest where that is no time at all.
    [[nodiscard]] const trace::MovingScene& moving() const { return moving_ ? *moving_ : atRest_; }
    /// nullptr: not asked for.
    [[nodiscard]] const AnalyticLights* analytic() const { return analytic_ ? &*analytic_ : nullptr; }

private:
    const trace::SceneTracer& tracer_;
    trace::MovingScene atRest_;
    std::optional<trace::MovingScene> moving_;
    std::optional<AnalyticLights> analytic_;
    // What they were made of.
    scene::Snapshot movingSnapshot_, analyticSnapshot_;
    trace::Structure movingStructure_ = trace::Structure::bvh;
};

} // namespace shadowlab::ray_tracing
