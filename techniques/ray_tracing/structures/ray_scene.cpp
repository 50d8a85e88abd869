// SPDX-License-Identifier: MIT
#include "techniques/ray_tracing/structures/ray_scene.h"

#include "techniques/ray_tracing/structures/naive_intersection.h"

namespace shadowlab::ray_tracing {

Progress RayScene::prepare(const scene::Snapshot& snapshot, const StructureParams& params, Deadline deadline) {
    tracer_.askInstead(nullptr);
    if (!tracer_.advance(snapshot, deadline)) return {tracer_.done(), false};
    // Surfaces do not depend on lights, which move most often: they are kept then.
    const scene::Revisions& now = snapshot->revisions;
    if (now.geometry != surfacesRevisions_.geometry || now.transforms != surfacesRevisions_.transforms ||
        now.materials != surfacesRevisions_.materials)
        surfaces_.emplace(tracer_);
    surfacesRevisions_ = now;
    const Progress progress = structures_.prepare(tracer_.geometry(), params.structure, deadline);
    if (!progress.converged) return progress;
    if (structures_.chosen() != trace::Structure::bvh) tracer_.askInstead(&structures_.engine());
    naive_.reset();
    if (params.intersection == StructureParams::Intersection::naive) {
        naive_ = makeNaiveEngine(tracer_.geometry()->bvh, static_cast<float>(params.edgeMargin));
        tracer_.askInstead(naive_.get());
    }
    return {};
}

} // namespace shadowlab::ray_tracing
