// Caches acceleration structures: each is built when it is first asked for, in slices, and kept until the geometry changes.
// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <memory>

#include "techniques/foundation/trace/structures/engine.h"
#include "techniques/foundation/trace/traced_geometry.h"
#include "techniques/technique.h"

namespace shadowlab::ray_tracing {

class StructureCache {
public:
    /// Continues building the structure over that geometry; not converged when the deadline has passed.
    Progress prepare(std::shared_ptr<const trace::TracedGeometry> geometry, trace::Structure structure,
                     Deadline deadline);

    /// Was this last prepared, and is it finished?
    [[nodiscard]] bool isReady(const std::shared_ptr<const trace::TracedGeometry>& geometry,
                               trace::Structure structure) const {
        return geometry == geometry_ && structure == chosen_ && built_[static_cast<std::size_t>(chosen_)] &&
               engine().done() == 1.0;
    }

    /// The structure last prepared: the tree of boxes where the program was built without the one that was asked for.
    [[nodiscard]] const trace::Engine& engine() const { return *built_[static_cast<std::size_t>(chosen_)]; }
    [[nodiscard]] trace::Structure chosen() const { return chosen_; }

    /// What they are built over.
private:
    std::shared_ptr<const trace::TracedGeometry> geometry_;
    std::array<std::unique_ptr<trace::Engine>, trace::kStructureCount> built_;
    trace::Structure chosen_ = trace::Structure::bvh;
};

} // namespace shadowlab::ray_tracing
