// SPDX-License-Identifier: MIT
#include "techniques/ray_tracing/structures/structure_cache.h"

#include <utility>

namespace shadowlab::ray_tracing {

Progress StructureCache::prepare(std::shared_ptr<const trace::TracedGeometry> geometry, trace::Structure structure,
                                 Deadline deadline) {
    if (geometry != geometry_) {
        built_ = {};
        geometry_ = std::move(geometry);
    }
    chosen_ = structure;
    auto* engine = &built_[static_cast<std::size_t>(chosen_)];
    if (!*engine && chosen_ != trace::Structure::bvh)
        *engine = trace::makeEngine(chosen_, {geometry_->world.triangles, geometry_->world.firstOfObject});
    if (!*engine) { // the tree of boxes already exists
        chosen_ = trace::Structure::bvh;
        engine = &built_[static_cast<std::size_t>(chosen_)];
        if (!*engine) *engine = trace::makeBvhEngine(geometry_->bvh);
    }
    if ((*engine)->advance(deadline)) return {};
    return {(*engine)->done(), false};
}

} // namespace shadowlab::ray_tracing
