// The structures that were asked for so far: each is built once, in slices, and kept until the geometry changes.
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
    /// Goes on building the structure over that geometry; unconverged when the deadline passes.
    Progress prepare(std::shared_ptr<const trace::TracedGeometry> geometry, trace::Structure structure,
                     Deadline deadline);

    /// Was this last prepared, and is it finished?
    [[nodiscard]] bool isReady(const std::shared_ptr<const trace::TracedGeometry>& geometry,
                               trace::Structure structure) const {
        return geometry == geometry_ && structure == chosen_ && built_[static_cast<std::size_t>(chosen_)] &&
               engine().done() == 1.0;
    }

    /// The structure last prepared: the tree where the program was built without the one that was asked for.
    [[nodiscard]] const trace::Engine& engine() const { return *built_[static_cast<std::size_t>(chosen_)]; }
    [[nodiscard]] trace::Structure chosen() const { return chosen_; }

private:
    std::shared_ptr<const trace::TracedGeometry> geometry_; ///< what all of them are built over
    std::array<std::unique_ptr<trace::Engine>, trace::kStructureCount> built_;
    trace::Structure chosen_ = trace::Structure::bvh;
};

} // namespace shadowlab::ray_tracing
