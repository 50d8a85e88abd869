// SPDX-License-Identifier: MIT
#include "techniques/shadow_map/maps/averaged_light.h"

#include "techniques/foundation/gl/baseline.h"
#include "techniques/foundation/scene/query/casters.h"
#include "techniques/foundation/scene/query/light_points.h"

namespace shadowlab::shadow_map {

bool AveragedLight::averagesOver(const scene::Light& light) const {
    return tools_.params.lightPoints.count > 1 && scene::hasArea(light);
}

const gl::Texture2D& AveragedLight::average(Frame& frame, int light) {
    const scene::Scene& scene = frame.scene();
    const scene::Light& whole = scene.light(light);
    const ivec2 size = frame.target().size();
    averaged_ = gl::Texture2D(GL_R32F, size, "visibility, averaged over the light");
    const gl::Framebuffer framebuffer(&averaged_, &frame.target().depthStencil, "visibility, averaged over the light");
    framebuffer.bind();
    glDisable(GL_SCISSOR_TEST);
    glClear(GL_COLOR_BUFFER_BIT);
    const float share = 1.0f / static_cast<float>(tools_.params.lightPoints.count);
    const std::vector<scene::Bounds> receivers = tools_.fitter.receiversInView(scene, frame.view());
    MapDrawer::OwnMap own;
    // [anchor: average-maps]
    for (const dvec3& pointWorld : scene::pointsOfLight(whole, light, tools_.params.lightPoints)) {
        MapQuery query = tools_.fitter.query(scene, light);
        query.light.type = scene::LightType::point;
        query.light.positionWorld = pointWorld;
        query.casters = scene::usefulCasters(scene, query.light, tools_.fitter.bounds());
        const LightMaps maps = tools_.fitter.fit(scene, frame.view(), query, receivers);
        const LightShadowMap map = tools_.drawer.drawAnew(frame, query, maps, own);
        frame.count("maps-redrawn", maps.layers(), maps.layers(), "maps");
        gl::setBaselineState();
        framebuffer.bind();
        frame.scissorTo(std::nullopt);
        glClear(GL_STENCIL_BUFFER_BIT);
        gl::setVisibilityState();
        glEnable(GL_BLEND);
        glBlendColor(share, share, share, share);
        glBlendFunc(GL_CONSTANT_COLOR, GL_ONE);
        tools_.receivers.drawVisibility(frame, light, map);
    }
    return averaged_;
}

} // namespace shadowlab::shadow_map
