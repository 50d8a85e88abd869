// The lights of a scene that have an area, prepared for closed-form visibility and irradiance.
// SPDX-License-Identifier: MIT
#pragma once
#include <memory>
#include <vector>

#include "techniques/foundation/trace/area/area_visibility.h"

namespace shadowlab::ray_tracing {

class AnalyticLights {
public:
    /// The tracer and its scene must outlive this object.
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

    /// Per light.
private:
    std::vector<std::unique_ptr<trace::AreaVisibility>> areas_;
};

} // namespace shadowlab::ray_tracing
