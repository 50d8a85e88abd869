// SPDX-License-Identifier: MIT
#include "techniques/shadow_map/map_tools.h"

#include "techniques/foundation/gl/baseline.h"
#include "techniques/lights_in_view.h"

namespace shadowlab::shadow_map {

void addLight(MapTools& tools, Frame& frame, int light, const LightShadowMap& map) {
    if (tools.params.cull && !mayLight(frame, light)) return;
    glClear(GL_STENCIL_BUFFER_BIT);
    gl::setAddLightState();
    tools.receivers.drawLight(frame, light, map, false);
}

void publishVisibility(MapTools& tools, Frame& frame, int light, const LightShadowMap& map) {
    frame.drawStage(kVisibilityStage, light, GL_RG32F, [&] {
        glClear(GL_STENCIL_BUFFER_BIT);
        gl::setVisibilityState();
        tools.receivers.drawLight(frame, light, map, true);
    });
}

} // namespace shadowlab::shadow_map
