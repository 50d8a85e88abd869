// A scene ready for rays: its triangles in the chosen acceleration structure, the test that finds hits, and its surfaces. Each part is
// kept until what it depends on changes.
// SPDX-License-Identifier: MIT
#pragma once
#include <memory>
#include <optional>

#include "techniques/foundation/trace/scene_tracer.h"
#include "techniques/ray_tracing/params.h"
#include "techniques/ray_tracing/structures/structure_cache.h"

namespace shadowlab::ray_tracing {

class RayScene {
public:
    /// Continues preparing the scene; not converged when the deadline has passed.
    Progress prepare(const scene::Snapshot& snapshot, const StructureParams& params, Deadline deadline);

    // The functions below but the first may be called once prepare() has converged.

    [[nodiscard]] const trace::SceneTracer& tracer() const { return tracer_; }
    [[nodiscard]] const Surfaces& surfaces() const { return *surfaces_; }
    [[nodiscard]] const StructureCache& structures() const { return structures_; }

private:
    trace::SceneTracer tracer_;
    StructureCache structures_;
    std::unique_ptr<trace::Engine> naive_; ///< traces in place of the structure; nullptr: intersection is watertight
    std::optional<Surfaces> surfaces_;
    scene::Revisions surfacesRevisions_{0, 0, 0, 0}; ///< of surfaces_; no scene has zeros
};

} // namespace shadowlab::ray_tracing
