// SPDX-License-Identifier: MIT
#include "techniques/shadow_map/map_tools.h"

#include "techniques/foundation/gl/baseline.h"
#include "techniques/lights_in_view.h"

namespace shadowlab::shadow_map {

void addLight(MapTools& tools, Frame& frame, int light, const LightShadowMap& map) {
    const bool isLeftOut = tools.params.cull && !mayLight(frame, light);
    if (isLeftOut && !frame.drawsFinished()) return; // finished pixels are drawn here, lit or not
    glClear(GL_STENCIL_BUFFER_BIT);
    tools.receivers.drawLight(frame, light, map, tools.passes.beginLight(frame));
}

void publishVisibility(MapTools& tools, Frame& frame, int light, const LightShadowMap& map) {
    frame.drawStage(kVisibilityStage, light, GL_RG32F, [&] {
        glClear(GL_STENCIL_BUFFER_BIT);
        gl::setVisibilityState();
        tools.receivers.drawVisibility(frame, light, map);
    });
}

} // namespace shadowlab::shadow_map
