// The lights of a scene that have an area, ready to be asked in closed form how much of them a point sees, and what it receives.
// SPDX-License-Identifier: MIT
#pragma once
#include <memory>
#include <vector>

#include "techniques/foundation/trace/area/area_visibility.h"

namespace shadowlab::ray_tracing {

class AnalyticLights {
public:
    /// The tracer must live as long, with the scene that it has.
    explicit AnalyticLights(const trace::SceneTracer& tracer) {
        for (int light = 0; light < static_cast<int>(tracer.scene().lights.size()); ++light)
            areas_.push_back(scene::hasArea(tracer.scene().light(light))
                                 ? std::make_unique<trace::AreaVisibility>(tracer, light)
                                 : nullptr);
    }
    /// nullptr: the light has no area.
    [[nodiscard]] const trace::AreaVisibility* area(int light) const {
        return areas_[static_cast<std::size_t>(light)].get();
    }

private:
    std::vector<std::unique_ptr<trace::AreaVisibility>> areas_; ///< per light
};

} // namespace shadowlab::ray_tracing
