// SPDX-License-Identifier: MIT
#include "techniques/ray_tracing/sampling/sampling_scene.h"

#include <algorithm>

namespace shadowlab::ray_tracing {

namespace {

/// Do all objects move alike? Lights may differ.
bool sameMotion(const scene::Snapshot& a, const scene::Snapshot& b) {
    return a && b && a->revisions.geometry == b->revisions.geometry &&
           a->revisions.transforms == b->revisions.transforms &&
           std::ranges::equal(a->objects, b->objects, {}, &scene::Object::velocityWorld, &scene::Object::velocityWorld);
}

} // namespace

Progress SamplingScene::prepare(const scene::Snapshot& snapshot, trace::Structure structure,
                                const SamplingParams& params, Deadline deadline) {
    if (!params.isAnalytic())
        analytic_.reset();
    else if (!analytic_ || analyticSnapshot_ != snapshot)
        analytic_.emplace(tracer_);
    analyticSnapshot_ = snapshot;

    if (!params.areMany() || params.shutter == 0) {
        moving_.reset();
        return {};
    }
    if (!moving_ || movingStructure_ != structure || !sameMotion(movingSnapshot_, snapshot))
        moving_.emplace(tracer_, structure);
    movingSnapshot_ = snapshot;
    movingStructure_ = structure;
    if (moving_->advance(deadline)) return {};
    return {moving_->done(), false};
}

} // namespace shadowlab::ray_tracing
